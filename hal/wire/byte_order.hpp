#pragma once
/// @file  Numbers as bytes, least significant first, on every machine.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace articam::wire {

template <std::unsigned_integral T>
constexpr void store(T x, std::span<std::uint8_t, sizeof(T)> bytes) noexcept {
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = static_cast<std::uint8_t>(x >> 8 * i);
}

template <std::unsigned_integral T>
constexpr T load(std::span<const std::uint8_t, sizeof(T)> bytes) noexcept {
  T x = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) x = static_cast<T>(x | static_cast<T>(bytes[i]) << 8 * i);
  return x;
}

}  // namespace articam::wire
