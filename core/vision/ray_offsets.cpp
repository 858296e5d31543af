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

// The filter times the profile's second derivative, shifted down to 14 bits.
struct Curvature {
  PerSample filtered;
  int down;
};
Curvature curvature_of(const EdgeProfile& profile) noexcept {
  const PerSample& F = profile.filter_q4;
  std::array<std::int32_t, kSamples> product{};
  std::int32_t most = 1;
  for (std::size_t j = 1; j + 1 < kSamples; ++j) {
    product[j] = F[j] * (profile.mean_q4[j - 1] - 2 * profile.mean_q4[j] + profile.mean_q4[j + 1]);
    most = std::max(most, std::abs(product[j]));
  }
  Curvature out{{}, std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint32_t>(most))) - 13)};
  for (std::size_t j = 0; j < kSamples; ++j) out.filtered[j] = static_cast<std::int16_t>(product[j] >> out.down);
  return out;
}

// The radius grows along u and v by cos / m00 - sin m10 / (m00 m11) and by sin / m11: squares, as shares of the square
// of its steepest growth, 1 / minor.
struct Growth {
  PerRay uu_q14, vv_q14;
};
Growth growth_of(const Ellipse& e, std::int64_t minor_q16, int rays) noexcept {
  Growth out;
  const auto cos_u = static_cast<std::int32_t>((minor_q16 << kQ14) / e.m00_q16);
  const auto sin_v = static_cast<std::int32_t>((minor_q16 << kQ14) / e.m11_q16);
  const auto sin_u = static_cast<std::int32_t>(-std::int64_t{cos_u} * e.m10_q16 / e.m11_q16);
  const Wave& wave = wave_of(rays, 1);
  for (std::size_t k = 0; k < static_cast<std::size_t>(rays); ++k) {
    const std::int32_t u = (wave.cos_q14[k] * cos_u + wave.sin_q14[k] * sin_u) >> kQ14;
    const std::int32_t v = wave.sin_q14[k] * sin_v >> kQ14;
    out.uu_q14[k] = static_cast<std::int16_t>(u * u >> kQ14);
    out.vv_q14[k] = static_cast<std::int16_t>(v * v >> kQ14);
  }
  return out;
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

// The product, of a ray less that of the profile, is a share of D.F.
void find_offsets(const RaySamples& samples, const EdgeProfile& profile, const PerRay& crosses,
                  RayOffsets& out) noexcept {
  const PerSample& F = profile.filter_q4;
  std::array<std::int32_t, kMaxRays> with_slope;
  const auto rays = static_cast<std::size_t>(samples.rays);
  for (std::size_t k = 0; k < rays; ++k) with_slope[k] = dot(samples.grey_q4[k], F);
  out.rays = samples.rays;
  put_shares(dot(profile.mean_q4, F), with_slope, samples.rays, dot(profile.slope_q4, F) + 1, 8, out.rho_q8);
  for (std::size_t k = 0; k < rays; ++k) out.rho_q8[k] = static_cast<std::int16_t>(out.rho_q8[k] & crosses[k]);
  out.seen_q16 = out.harmonic_q16(1);
}

void take_off_blending(const RaySamples& samples, const EdgeProfile& profile, const PerRay& crosses, const Ellipse& e,
                       std::int64_t minor_q16, std::int32_t half_window_q16, RayOffsets& io) noexcept {
  const auto rays = static_cast<std::size_t>(samples.rays);
  const Growth growth = growth_of(e, minor_q16, samples.rays);
  const Curvature curvature = curvature_of(profile);
  std::array<std::int32_t, kMaxRays> blended_q14;
  for (std::size_t k = 0; k < rays; ++k) {
    PerSample beside_q14;
    for (std::size_t j = 0; j < kSamples; ++j) {
      const std::int16_t right = samples.right_q8[k][j], down = samples.down_q8[k][j];
      const auto f_right_q16 = static_cast<std::int16_t>(right * (256 - right)),
                 f_down_q16 = static_cast<std::int16_t>(down * (256 - down));
      const auto along_u_q14 = static_cast<std::int16_t>(f_right_q16 * growth.uu_q14[k] >> 16),
                 along_v_q14 = static_cast<std::int16_t>(f_down_q16 * growth.vv_q14[k] >> 16);
      beside_q14[j] = static_cast<std::int16_t>(along_u_q14 + along_v_q14);
    }
    blended_q14[k] = dot(curvature.filtered, beside_q14);
  }
  // What blending adds on average, f (1 - f) being a sixth, is part of the blur.
  std::int32_t sum = 0;
  for (const int h : curvature.filtered) sum += h;
  for (std::size_t k = 0; k < rays; ++k) blended_q14[k] -= (growth.uu_q14[k] + growth.vv_q14[k]) * sum / 6;

  // 1 / (2 narrow^2), narrow the px between samples where they are nearest, by D.F.
  const std::int64_t narrow_q16 = 2 * half_window_q16 * minor_q16 / (kSamples - 1) >> kQ16;
  const std::int64_t per_px2_q16 = (std::int64_t{1} << 47) / std::max<std::int64_t>(square(narrow_q16), 1 << 26);
  const std::int64_t filter = dot(profile.slope_q4, profile.filter_q4) + 1;
  constexpr std::int64_t kMost = 1 << 14;
  const auto scale = static_cast<std::int32_t>(std::min((per_px2_q16 << (8 + curvature.down)) / filter, kMost));
  for (std::size_t k = 0; k < rays; ++k) {
    const std::int32_t moved_q8 = (blended_q14[k] >> 14) * scale >> 16;
    io.rho_q8[k] = static_cast<std::int16_t>((io.rho_q8[k] + moved_q8) & crosses[k]);
  }
  io.seen_q16 = io.harmonic_q16(1);
}

void find_light(const RaySamples& samples, const EdgeProfile& profile, std::int32_t half_window_q16,
                RayOffsets& out) noexcept {
  const PerSample &P = profile.mean_q4, &D = profile.slope_q4, &F = profile.filter_q4;
  const PerSample G = lit_part(profile, half_window_q16);
  const std::int32_t GG = dot(G, G) + 1;
  std::array<std::int32_t, kMaxRays> with_lit;
  const auto rays = static_cast<std::size_t>(samples.rays);
  for (std::size_t k = 0; k < rays; ++k) with_lit[k] = dot(samples.grey_q4[k], G);
  PerRay dark_q11;  // brightness differs by a half at most
  put_shares(dot(P, G), with_lit, samples.rays, GG, 11, dark_q11);

  // For the first harmonics: dark = shift DG / GG - gain, rho = shift - gain GF / DF.
  const Harmonic dark_q19 = harmonic_q16(dark_q11, samples.rays, 1), rho = out.seen_q16;
  const std::int64_t DG_GG_q16 = (std::int64_t{dot(D, G)} << 16) / GG;
  out.per_gain_q16 = (std::int64_t{dot(G, F)} << 16) / (dot(D, F) + 1);
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
