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
  static_assert(std::int64_t{kSamples} * 8160 * 8160 < std::int64_t{1} << 31, "twice the largest grey level, Q4");
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

// The derivative of the profile, weighted by its own steepness. Farther out it tells little of the edge, and what lies
// there of others. A threshold in its place would take samples in and out while the ellipse moves by hundredths of px.
PerSample steep_part(const EdgeProfile& profile) noexcept {
  PerSample filter = profile.slope_q4;
  int steepest = 1;
  for (const int slope : filter) steepest = std::max(steepest, std::abs(slope));
  for (std::int16_t& slope : filter) slope = static_cast<std::int16_t>(slope * std::abs(slope) / steepest);
  return filter;
}

// What the profile becomes per gain: light that grows by g a radius grows by g r up to the radius r of the sample.
PerSample lit_part(const EdgeProfile& profile, std::int32_t half_window_q16) noexcept {
  PerSample lit;
  for (int j = 0; j < kSamples; ++j) {
    const std::int32_t radius_q16 = kOne_q16 + half_window_q16 * (2 * j - (kSamples - 1)) / (kSamples - 1);
    const std::int32_t radius_q12 = std::clamp<std::int32_t>(radius_q16 >> 4, 0, 2 << 12);
    const auto i = static_cast<std::size_t>(j);
    lit[i] = static_cast<std::int16_t>(profile.mean_q4[i] * radius_q12 >> 12);
  }
  return lit;
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

void find_offsets(const RaySamples& samples, const EdgeProfile& profile, const PerRay& crosses,
                  std::int32_t half_window_q16, RayOffsets& out) noexcept {
  const PerSample &P = profile.mean_q4, &D = profile.slope_q4;
  const PerSample G = lit_part(profile, half_window_q16), F = steep_part(profile);
  const std::int32_t GG = dot(G, G) + 1, PG = dot(P, G), PF = dot(P, F), DF = dot(D, F) + 1;
  // Both products, of the rays less those of the profile, as shares of G.G and D.F.
  std::array<std::int32_t, kMaxRays> with_lit, with_slope;
  const auto rays = static_cast<std::size_t>(samples.rays);
  for (std::size_t k = 0; k < rays; ++k) {
    with_lit[k] = dot(samples.grey_q4[k], G);
    with_slope[k] = dot(samples.grey_q4[k], F);
  }
  out.rays = samples.rays;
  PerRay dark_q11;  // brightness differs by a half at most
  put_shares(PG, with_lit, samples.rays, GG, 11, dark_q11);
  put_shares(PF, with_slope, samples.rays, DF, 8, out.rho_q8);
  for (std::size_t k = 0; k < rays; ++k) out.rho_q8[k] = static_cast<std::int16_t>(out.rho_q8[k] & crosses[k]);

  // For the first harmonics: dark = shift DG / GG - gain, rho = shift - gain GF / DF.
  const Harmonic dark_q19 = harmonic_q16(dark_q11, samples.rays, 1), rho = out.seen_q16 = out.harmonic_q16(1);
  const std::int64_t DG_GG_q16 = (std::int64_t{dot(D, G)} << 16) / GG;
  out.per_gain_q16 = (std::int64_t{dot(G, F)} << 16) / DF;
  constexpr std::int64_t kMostShared_q16 = kOne_q16 - kOne_q16 / 64;
  out.shared_q16 = std::clamp<std::int64_t>(DG_GG_q16 * out.per_gain_q16 >> 16, 0, kMostShared_q16);

  PerRay last_q2;
  static_assert(255 * 4 <= kLimit_q8, "the range of grey levels fits");
  for (std::size_t k = 0; k < rays; ++k)
    last_q2[k] = static_cast<std::int16_t>((samples.grey_q4[k].back() - P.back()) >> 2);
  const Harmonic last_q10 = harmonic_q16(last_q2, samples.rays, 1);
  const auto put = [&](std::int64_t dark, std::int64_t shift, std::int64_t last, std::int64_t& light,
                       std::int64_t& beside) {
    constexpr std::int64_t kLimit_q16 = kLimit_q8 * 256, kMostRest_q10 = 1 << 20;
    const std::int64_t gain_q16 = (((shift * DG_GG_q16 >> 16) - (dark >> 3)) << 16) / (kOne_q16 - out.shared_q16);
    light = std::clamp(gain_q16 * out.per_gain_q16 >> 16, -kLimit_q16, kLimit_q16);
    // What the last sample shows beside light; of a shift it shows nothing. As a gain it is its share of G.G.
    const std::int64_t rest_q10 = last - (gain_q16 * G.back() >> 10);
    const std::int64_t rest_gain_q16 =
        (std::clamp(rest_q10, -kMostRest_q10, kMostRest_q10) * G.back() * (1 << 10)) / GG;
    beside = std::clamp(rest_gain_q16 * out.per_gain_q16 >> 16, -kLimit_q16, kLimit_q16);
  };
  put(dark_q19.a, rho.a, last_q10.a, out.light_q16.a, out.beside_q16.a);
  put(dark_q19.b, rho.b, last_q10.b, out.light_q16.b, out.beside_q16.b);
}

}  // namespace articam::vision
