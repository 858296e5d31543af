#include "core/vision/ray_offsets.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace articam::vision {
namespace {

// A ray that meets something else does not carry the rest away.
constexpr std::int32_t kLimit_q8 = 4 * 256 - 1;
static_assert(std::int64_t{kLimit_q8} * (1 << kQ14) * kMaxRays < std::int64_t{1} << 31, "sums of products fit");

Harmonic harmonic_q16(const PerRay& x_q8, int rays, int n) noexcept {
  const Wave& wave = wave_of(rays, n);
  std::int32_t a = 0, b = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(rays); ++k) {
    a += x_q8[k] * wave.cos_q14[k];
    b += x_q8[k] * wave.sin_q14[k];
  }
  const std::int64_t half_q6 = std::int64_t{rays / 2} << (kQ14 - 8);
  return {a / half_q6, b / half_q6};
}

std::int32_t dot(const PerSample& a, const PerSample& b) noexcept {
  static_assert(std::int64_t{kSamples} * 4080 * 4080 < std::int64_t{1} << 31);
  std::int32_t sum = 0;
  for (std::size_t j = 0; j < kSamples; ++j) sum += a[j] * b[j];
  return sum;
}

// out = 2^fraction (whole - part) / divisor, in 32 bits: of the divisor its 13 leading ones count.
void put_shares(std::int32_t whole, const std::array<std::int32_t, kMaxRays>& parts, int rays, std::int32_t divisor,
                int fraction, PerRay& out) noexcept {
  const int down = std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint32_t>(divisor))) - 13);
  const std::int32_t leading = divisor >> down, inverse = (1 << 26) / leading;
  const std::int32_t most = static_cast<std::int32_t>(std::int64_t{leading} * kLimit_q8 >> fraction);
  for (std::size_t k = 0; k < static_cast<std::size_t>(rays); ++k) {
    const std::int32_t miss = std::clamp((whole - parts[k]) >> down, -most, most);
    out[k] = static_cast<std::int16_t>(miss * inverse >> (26 - fraction));
  }
}
static_assert(kLimit_q8 < 1 << 10, "with fractions of 8 bits or more, a share times 2^26 fits");

// The derivative of the profile where it is steep. Farther out it tells little of the edge, and what lies there of
// others.
PerSample steep_part(const EdgeProfile& profile) noexcept {
  PerSample filter = profile.slope_q4;
  int steepest = 0;
  for (const int slope : filter) steepest = std::max(steepest, std::abs(slope));
  for (std::int16_t& slope : filter) slope = 5 * std::abs(slope) < 2 * steepest ? std::int16_t{0} : slope;
  return filter;
}

// How much of a brightness that differs by `gain` over a radius is believed to be the light's, Q16.
std::int64_t belief_q16(const Harmonic& gain_q16, std::int64_t doubt_q16) noexcept {
  const std::int64_t gain2 = (square(gain_q16.a) + square(gain_q16.b)) >> 12, doubt2 = square(doubt_q16) >> 12;
  const std::int64_t power = square(gain2) >> 8, noise = square(doubt2) >> 8;
  return (power << 16) / std::max<std::int64_t>(power + noise, 1);
}

}  // namespace

Harmonic RayOffsets::harmonic_q16(int n) const noexcept { return vision::harmonic_q16(rho_q8, rays, n); }

std::int64_t RayOffsets::scatter_q16(const Harmonic& first_q16, const Harmonic& second_q16) const noexcept {
  std::int64_t sum = 0, power_q16 = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(rays); ++k) sum += rho_q8[k], power_q16 += rho_q8[k] * rho_q8[k];
  const std::int64_t known_q32 =
      square(first_q16.a) + square(first_q16.b) + square(second_q16.a) + square(second_q16.b);
  power_q16 -= square(sum) / rays + (rays / 2 * known_q32 >> 16);
  constexpr int kUnknowns = 5;
  return std::max<std::int64_t>(power_q16, 0) / (rays - kUnknowns);
}

void find_offsets(const RaySamples& samples, const EdgeProfile& profile, const PerRay& crosses, std::int64_t doubt_q16,
                  RayOffsets& out) noexcept {
  const PerSample& P = profile.mean_q4;
  const PerSample F = steep_part(profile);
  const std::int32_t PP = dot(P, P) + 1, PF = dot(P, F), DF = dot(profile.slope_q4, F) + 1;
  const std::int64_t PD = dot(P, profile.slope_q4);
  // Both products, of the rays less those of the profile, as shares of P.P and D.F.
  std::array<std::int32_t, kMaxRays> with_mean, with_slope;
  const auto rays = static_cast<std::size_t>(samples.rays);
  for (std::size_t k = 0; k < rays; ++k) {
    with_mean[k] = dot(samples.grey_q4[k], P);
    with_slope[k] = dot(samples.grey_q4[k], F);
  }
  out.rays = samples.rays;
  PerRay dark_q12;  // brightness differs by a quarter at most
  put_shares(PP, with_mean, samples.rays, PP, 12, dark_q12);
  put_shares(PF, with_slope, samples.rays, DF, 8, out.rho_q8);
  // a = g - rho PD / PP, b = -g PF / DF + rho, for the first harmonics
  const Harmonic a_q20 = harmonic_q16(dark_q12, samples.rays, 1), b = out.harmonic_q16(1);
  const std::int64_t PD_PP_q16 = (PD << 16) / PP, PF_DF_q16 = (std::int64_t{PF} << 16) / DF;
  const std::int64_t det_q16 = std::max<std::int64_t>(kOne_q16 - (PD_PP_q16 * PF_DF_q16 >> 16), kOne_q16 / 64);
  const auto gain_q16 = [&](std::int64_t mean_q16, std::int64_t slope_q16) {
    return ((mean_q16 + (slope_q16 * PD_PP_q16 >> 16)) << 16) / det_q16;
  };
  const Harmonic gain{gain_q16(-a_q20.a >> 4, b.a), gain_q16(-a_q20.b >> 4, b.b)};
  const std::int64_t belief = belief_q16(gain, doubt_q16);
  const Wave& wave = wave_of(samples.rays, 1);
  const Harmonic whole{gain.a * PF_DF_q16 >> 16, gain.b * PF_DF_q16 >> 16};
  out.doubted_q32 = (square(whole.a) + square(whole.b)) / 2 * (belief * (kOne_q16 - belief) >> 16) >> 16;
  const auto shift_q12 = [belief](std::int64_t x) {
    return static_cast<std::int16_t>(std::clamp<std::int64_t>(x * belief >> 20, -kLimit_q8 * 16, kLimit_q8 * 16));
  };
  const std::int16_t shift_a = shift_q12(whole.a), shift_b = shift_q12(whole.b);
  for (std::size_t k = 0; k < rays; ++k) {
    const int shift_q8 = (shift_a * wave.cos_q14[k] + shift_b * wave.sin_q14[k]) >> (kQ14 + 4);
    const auto rho_q8 = static_cast<std::int16_t>(out.rho_q8[k] + shift_q8);
    out.rho_q8[k] = static_cast<std::int16_t>(std::clamp<std::int16_t>(rho_q8, -kLimit_q8, kLimit_q8) & crosses[k]);
  }
}

}  // namespace articam::vision
