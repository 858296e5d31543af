#pragma once
/// @file  A line of text with its storage inside.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace articam::hal {

/// A number to be written with leading zeros: all hexadecimal digits of an unsigned, or so many decimal ones.
struct Digits {
  std::uint64_t value;
  int count;
  unsigned base;
};
template <std::unsigned_integral T>
constexpr Digits hex(T value) noexcept {
  return {value, 2 * static_cast<int>(sizeof(T)), 16};
}
constexpr Digits decimal(std::uint32_t value, int count) noexcept { return {value, count, 10}; }

/// Up to 255 characters and a terminating zero; what exceeds them is left out.
class Line {
 public:
  constexpr Line& operator<<(char c) noexcept {
    if (size_ + 1 < text_.size()) text_[size_++] = c;
    return *this;
  }
  constexpr Line& operator<<(std::string_view text) noexcept {
    for (const char c : text) *this << c;
    return *this;
  }
  constexpr Line& operator<<(const char* text) noexcept { return *this << std::string_view{text}; }
  constexpr Line& operator<<(const Digits& digits) noexcept {
    std::array<char, 20> backwards{};
    std::uint64_t rest = digits.value;
    for (std::size_t i = 0; i < backwards.size(); ++i, rest /= digits.base) {
      backwards[i] = "0123456789abcdef"[rest % digits.base];
    }
    for (int i = digits.count; i-- > 0;) *this << backwards[static_cast<std::size_t>(i)];
    return *this;
  }
  template <std::integral T>
  requires(!std::same_as<T, char> && !std::same_as<T, bool>) constexpr Line& operator<<(T number) noexcept {
    auto rest = static_cast<std::uint64_t>(number);
    if (number < 0) {
      *this << '-';
      rest = 0 - rest;
    }
    int count = 1;
    for (std::uint64_t more = rest / 10; more > 0; more /= 10) ++count;
    return *this << Digits{rest, count, 10};
  }

  constexpr std::string_view text() const noexcept { return {text_.data(), size_}; }
  constexpr const char* c_str() const noexcept { return text_.data(); }

 private:
  std::array<char, 256> text_{};
  std::size_t size_{};
};

}  // namespace articam::hal
