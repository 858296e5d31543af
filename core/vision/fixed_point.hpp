#pragma once
/// @file  Integer arithmetic of the detector: the same bits on every machine.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace articam::vision {

inline constexpr std::int32_t kOne_q16 = 1 << 16;
inline constexpr int kQ14 = 14;

constexpr std::int64_t square(std::int64_t x) noexcept { return x * x; }

/// Largest r with r * r <= x, for x below 2^62. IEEE's square root is rounded correctly everywhere; of a large x its
/// last bit may be one too many.
inline std::int64_t integer_sqrt(std::int64_t x) noexcept {
  if (x <= 0) return 0;
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(x)));
  root -= root * root > x ? 1 : 0;
  root += (root + 1) * (root + 1) <= x ? 1 : 0;
  return root;
}

/// Directions of the rays that leave a mark's centre.
inline constexpr int kDirections = 128;

/// cos and sin of n turns in `rays` equal steps, Q14, contiguous so that sums with them become vector instructions.
struct Wave {
  std::array<std::int16_t, kDirections> cos_q14{}, sin_q14{};
};

namespace detail {
// Taylor's series on an eighth of a turn; evaluated by the compiler only.
consteval double cosine(double x) {
  double term = 1, sum = 1;
  for (int n = 1; n < 12; ++n) sum += term *= -x * x / ((2 * n - 1) * (2 * n));
  return sum;
}
consteval std::int16_t cosine(int k, int scale) {  // of k / kDirections of a turn
  constexpr double kPi = 3.14159265358979323846;
  k %= kDirections;
  if (k > kDirections / 2) k = kDirections - k;
  const bool negative = k > kDirections / 4;
  if (negative) k = kDirections / 2 - k;
  const auto size = static_cast<std::int16_t>(scale * cosine(2 * kPi * k / kDirections) + 0.5);
  return negative ? static_cast<std::int16_t>(-size) : size;
}
consteval Wave wave(int rays, int n) {
  Wave wave;
  for (int k = 0; k < rays; ++k) {
    const int turn = n * k * (kDirections / rays);
    wave.cos_q14[static_cast<std::size_t>(k)] = cosine(turn, 1 << 14);
    wave.sin_q14[static_cast<std::size_t>(k)] = cosine(turn + 3 * kDirections / 4, 1 << 14);
  }
  return wave;
}
consteval std::array<Wave, 4> waves(int rays) { return {wave(rays, 1), wave(rays, 2), wave(rays, 3), wave(rays, 4)}; }
inline constexpr std::array<std::array<Wave, 4>, 4> kWaves{waves(16), waves(32), waves(64), waves(128)};
}  // namespace detail

/// The n-th harmonic, 1 to 4, of 16, 32, 64 or 128 rays.
inline const Wave& wave_of(int rays, int n) noexcept {
  const std::size_t i = rays == 16 ? 0 : (rays == 32 ? 1 : (rays == 64 ? 2 : 3));
  return detail::kWaves[i][static_cast<std::size_t>(n - 1)];
}

}  // namespace articam::vision
