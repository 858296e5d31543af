#pragma once
/// @file  A grey image finer than 8 bits, on which the world is painted before the sensor rounds it.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace articam::sim {

/// Grey levels are kept in 1/64 (Q6): 255 grey is 16320. Integers, so that every compiler computes the same bits.
inline constexpr int kGreyBits = 6;
inline constexpr int kMaxGrey_q6 = 255 << kGreyBits;

constexpr int grey_q6(double grey) noexcept {
  const double scaled = grey * (1 << kGreyBits);
  return static_cast<int>(scaled + (scaled < 0 ? -0.5 : 0.5));
}

/// Row-major, without padding.
struct GreyPlane {
  int width_px{};
  int height_px{};
  std::vector<std::int16_t> q6;

  GreyPlane(int width, int height, int grey)
      : width_px{width},
        height_px{height},
        q6(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), static_cast<std::int16_t>(grey)) {}

  std::int16_t* row(int v_px) noexcept { return q6.data() + static_cast<std::ptrdiff_t>(v_px) * width_px; }
  const std::int16_t* row(int v_px) const noexcept { return q6.data() + static_cast<std::ptrdiff_t>(v_px) * width_px; }
};

}  // namespace articam::sim
