#pragma once
/// @file  The checksum of a packet.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace articam::wire {

namespace detail {
constexpr std::array<std::uint32_t, 256> crc32_table() noexcept {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t remainder = i;
    for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? 0xedb88320u : 0u);
    table[i] = remainder;
  }
  return table;
}
inline constexpr auto kCrc32Table = crc32_table();
}  // namespace detail

/// CRC-32 of IEEE 802.3 (zlib, PNG): polynomial 0x04c11db7 reflected, start and final inversion all ones. Finds every
/// error of up to 3 flipped bits in a packet of any length that we send, and every burst of up to 32 bits.
constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t remainder = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    remainder = (remainder >> 8) ^ detail::kCrc32Table[(remainder ^ byte) & 0xffu];
  }
  return ~remainder;
}

}  // namespace articam::wire
