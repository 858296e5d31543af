#pragma once
/// @file  Integer arithmetic of the detector: the same bits on every machine.

#include <array>
#include <bit>
#include <cstdint>

namespace articam::vision {

inline constexpr std::int32_t kOne_q16 = 1 << 16;

/// Largest r with r * r <= x.
constexpr std::uint32_t integer_sqrt(std::uint64_t x) noexcept {
  std::uint64_t root = 0;
  for (int shift = (63 - std::countl_zero(x | 1)) / 2; shift >= 0; --shift) {
    const std::uint64_t trial = root | std::uint64_t{1} << shift;
    if (trial * trial <= x) root = trial;
  }
  return static_cast<std::uint32_t>(root);
}

/// Directions of the rays that leave a mark's centre: ray k points to k / kRays of a turn.
inline constexpr int kRays = 32;
inline constexpr int kQ14 = 14;

/// cos(2 pi k / kRays), Q14, for every whole k.
constexpr std::int32_t ray_cos_q14(int k) noexcept {
  static_assert(kRays == 32, "the quarter below holds cos(2 pi k / 32)");
  constexpr std::array<std::int32_t, 9> kQuarter{16384, 16069, 15137, 13623, 11585, 9102, 6270, 3196, 0};
  const int turn = k & (kRays - 1);
  const int half = turn <= kRays / 2 ? turn : kRays - turn;
  return half <= kRays / 4 ? kQuarter[static_cast<std::size_t>(half)]
                           : -kQuarter[static_cast<std::size_t>(kRays / 2 - half)];
}
constexpr std::int32_t ray_sin_q14(int k) noexcept { return ray_cos_q14(k - kRays / 4); }

}  // namespace articam::vision
