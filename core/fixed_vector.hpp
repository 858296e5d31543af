#pragma once
/// @file  A list with its storage inside and a capacity that never grows.

#include <array>
#include <cstddef>
#include <type_traits>

namespace articam {

/// Up to Capacity plain values. A push into a full list is refused, and the caller is told.
template <class T, std::size_t Capacity>
class FixedVector {
  static_assert(std::is_trivially_destructible_v<T>, "plain values only");

 public:
  [[nodiscard]] constexpr bool push_back(const T& value) noexcept {
    if (size_ == Capacity) return false;
    items_[size_++] = value;
    return true;
  }
  constexpr void clear() noexcept { size_ = 0; }

  static constexpr std::size_t capacity() noexcept { return Capacity; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr bool full() const noexcept { return size_ == Capacity; }

  constexpr T& operator[](std::size_t i) noexcept { return items_[i]; }
  constexpr const T& operator[](std::size_t i) const noexcept { return items_[i]; }
  constexpr T* begin() noexcept { return items_.data(); }
  constexpr T* end() noexcept { return items_.data() + size_; }
  constexpr const T* begin() const noexcept { return items_.data(); }
  constexpr const T* end() const noexcept { return items_.data() + size_; }

 private:
  std::array<T, Capacity> items_{};
  std::size_t size_{};
};

}  // namespace articam
