#include "core/vision/edge_fit.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/vision/fixed_point.hpp"

namespace articam::vision {
namespace {

constexpr int kSamples = 12;              // along a ray
constexpr int kMiddle_q1 = kSamples - 1;  // twice the index of the radius 1
constexpr std::int32_t kMinContrast_q4 = 12 * 16;
// Half of the window across the edge, px: wide enough for a seed from the mask, then for a blurred edge.
constexpr std::array<std::int32_t, 4> kReach_px{6, 4, 4, 4};

using Samples = std::array<std::array<std::int16_t, kSamples>, kRays>;  // grey, Q4
using PerSample = std::array<std::int64_t, kSamples>;
using PerRay = std::array<std::int32_t, kRays>;

struct Point {
  std::int32_t u_q16, v_q16;
};

constexpr std::int64_t square(std::int64_t x) noexcept { return x * x; }

// Bilinear, Q4; beyond the image its border goes on.
std::int16_t sample_q4(const ImageView& image, Point p) noexcept {
  const int u_q8 = std::clamp<int>(p.u_q16 >> 8, 0, (image.width_px - 1) << 8);
  const int v_q8 = std::clamp<int>(p.v_q16 >> 8, 0, (image.height_px - 1) << 8);
  const int u = u_q8 >> 8, v = v_q8 >> 8, fu = u_q8 & 255, fv = v_q8 & 255;
  const std::uint8_t* above = image.row(v);
  const std::uint8_t* below = image.row(v + (fv != 0));
  const int right = u + (fu != 0);
  const int top = above[u] * (256 - fu) + above[right] * fu, bottom = below[u] * (256 - fu) + below[right] * fu;
  return static_cast<std::int16_t>((top * (256 - fv) + bottom * fv + (1 << 11)) >> 12);
}

void read_rays(const ImageView& image, const Ellipse& e, std::int32_t half_window_q16, Samples& samples) noexcept {
  const std::int64_t step_q16 = 2 * half_window_q16 / (kSamples - 1);
  const std::int64_t first_q16 = kOne_q16 - half_window_q16;
  for (int k = 0; k < kRays; ++k) {
    const std::int64_t du_q16 = std::int64_t{e.m00_q16} * ray_cos_q14(k) >> kQ14;
    const std::int64_t dv_q16 =
        (std::int64_t{e.m10_q16} * ray_cos_q14(k) + std::int64_t{e.m11_q16} * ray_sin_q14(k)) >> kQ14;
    Point p{e.u_q16 + static_cast<std::int32_t>(du_q16 * first_q16 >> kQ16),
            e.v_q16 + static_cast<std::int32_t>(dv_q16 * first_q16 >> kQ16)};
    const Point step{static_cast<std::int32_t>(du_q16 * step_q16 >> kQ16),
                     static_cast<std::int32_t>(dv_q16 * step_q16 >> kQ16)};
    for (std::int16_t& value : samples[static_cast<std::size_t>(k)]) {
      value = sample_q4(image, p);
      p = {p.u_q16 + step.u_q16, p.v_q16 + step.v_q16};
    }
  }
}

// The edge as all rays together see it. Sums over the rays are kept instead of means; positions are in samples.
struct Profile {
  std::int32_t contrast_q4;
  std::int64_t position_q16;  // of the edge, from the radius 1
  std::int64_t variance_q16;  // of the derivative, the width of the edge squared
  PerSample filter;           // w
  std::int64_t response;      // sum_j w_j P'_j
};

PerSample without_brightness(const PerSample& slope, const PerSample& sum) noexcept {
  std::int64_t slope_total = 0, total = 0;
  for (std::size_t j = 1; j + 1 < kSamples; ++j) slope_total += slope[j], total += sum[j];
  std::int64_t along = 0, squared = 1;
  constexpr int kUsed = kSamples - 2;
  for (std::size_t j = 1; j + 1 < kSamples; ++j) {
    const std::int64_t centred = sum[j] - total / kUsed;
    along += slope[j] * centred;
    squared += square(centred);
  }
  PerSample filter{};
  const std::int64_t part_q16 = along * (kOne_q16 / 4) / (squared / 4 + 1);  // |along| < 2^41
  for (std::size_t j = 1; j + 1 < kSamples; ++j) {
    filter[j] = slope[j] - slope_total / kUsed - (part_q16 * (sum[j] - total / kUsed) >> kQ16);
  }
  return filter;
}

bool find_profile(const Samples& samples, Inside inside, Profile& profile) noexcept {
  static_assert(kRays * 255 * 16 < 1 << 17, "bounds of the sums below");
  PerSample sum{}, slope{};
  for (const auto& ray : samples) {
    for (std::size_t j = 0; j < kSamples; ++j) sum[j] += ray[j];
  }
  const std::int64_t sign = inside == Inside::darker ? 1 : -1;
  std::int64_t steepest = 0;
  for (std::size_t j = 1; j + 1 < kSamples; ++j) {
    slope[j] = sum[j + 1] - sum[j - 1];
    steepest = std::max(steepest, sign * slope[j]);
  }
  const auto [low, high] = std::minmax_element(sum.begin(), sum.end());
  profile.contrast_q4 = static_cast<std::int32_t>((*high - *low) / kRays);
  if (profile.contrast_q4 < kMinContrast_q4 || sign * (sum.back() - sum.front()) * 2 < *high - *low) return false;

  // The place is the centroid of the squared slope near the radius 1, where neighbouring edges reach least.
  std::int64_t weight = 0, first = 0;
  for (std::size_t j = 3; j < kSamples - 3; ++j) {
    const std::int64_t w = square(std::max<std::int64_t>(sign * slope[j], 0) >> 3);
    weight += w;
    first += w * (2 * static_cast<std::int64_t>(j) - kMiddle_q1);
  }
  if (weight == 0) return false;
  profile.position_q16 = first * (kOne_q16 / 2) / weight;

  // A Gaussian edge of contrast C has the steepest slope C / (sigma sqrt(2 pi)); a difference over two samples widens
  // it by a box of that length. C^2 / (2 pi (slope / 2)^2) = 0.6366 (C / slope)^2.
  constexpr std::int64_t kTwoOverPi_q16 = 41722, kOfDifference_q16 = kOne_q16 / 3;
  if (6 * steepest < *high - *low) return false;  // flatter than a ramp over all samples; bounds the variance
  const std::int64_t ratio_q16 = (*high - *low) * kOne_q16 / steepest;
  profile.variance_q16 =
      std::max<std::int64_t>(0, (square(ratio_q16) >> kQ16) * kTwoOverPi_q16 / kOne_q16 - kOfDifference_q16);

  profile.filter = without_brightness(slope, sum);
  profile.response = 0;
  for (std::size_t j = 0; j < kSamples; ++j) profile.response += profile.filter[j] * slope[j];
  return profile.response > 0;
}

// The edge goes all round: but for a few, every ray crosses a third of the mean step at least.
bool is_closed(const Samples& samples, Inside inside, const Profile& profile) noexcept {
  const int sign = inside == Inside::darker ? 1 : -1;
  const auto weak = std::count_if(samples.begin(), samples.end(), [&](const auto& ray) {
    return 3 * sign * (ray[kSamples - 2] - ray[1]) < profile.contrast_q4;
  });
  return weak <= kRays / 8;
}

// Where each ray meets the edge, from the mean edge, in samples, Q16.
PerRay ray_offsets(const Samples& samples, const Profile& profile) noexcept {
  constexpr std::int64_t kLimit_q16 = 4 * kOne_q16;  // a ray that meets something else does not carry the rest away
  PerRay offsets;
  for (std::size_t k = 0; k < kRays; ++k) {
    std::int64_t product = 0;
    for (std::size_t j = 0; j < kSamples; ++j) product += profile.filter[j] * samples[k][j];
    // slope is the sum of kRays differences over two samples
    const std::int64_t offset_q16 = -product * (2 * kRays) * (kOne_q16 >> 6) / ((profile.response >> 6) + 1);
    offsets[k] = static_cast<std::int32_t>(std::clamp(offset_q16, -kLimit_q16, kLimit_q16));
  }
  return offsets;
}

// Fourier coefficients of the offsets: x = a cos + b sin of the n-th harmonic.
struct Harmonic {
  std::int64_t a, b;
};
Harmonic harmonic(const PerRay& offsets, int n) noexcept {
  Harmonic h{0, 0};
  for (int k = 0; k < kRays; ++k) {
    h.a += std::int64_t{offsets[static_cast<std::size_t>(k)]} * ray_cos_q14(n * k);
    h.b += std::int64_t{offsets[static_cast<std::size_t>(k)]} * ray_sin_q14(n * k);
  }
  constexpr std::int64_t kHalf = std::int64_t{kRays / 2} << kQ14;
  return {h.a / kHalf, h.b / kHalf};
}

// M <- lower triangular factor of M (1 + S), S = |s00 s10; s10 s11| small, Q16. False beyond the size of a frame.
bool deform(Ellipse& e, std::int64_t s00, std::int64_t s10, std::int64_t s11) noexcept {
  const std::int64_t a00 = e.m00_q16 + (e.m00_q16 * s00 >> kQ16), a01 = e.m00_q16 * s10 >> kQ16;
  const std::int64_t a10 = e.m10_q16 + ((e.m10_q16 * s00 + e.m11_q16 * s10) >> kQ16);
  const std::int64_t a11 = e.m11_q16 + ((e.m10_q16 * s10 + e.m11_q16 * s11) >> kQ16);
  constexpr std::int64_t kMax_q16 = std::int64_t{2} * std::max(kMaxImageWidth_px, kMaxImageHeight_px) * kOne_q16;
  static_assert(kMax_q16 < std::int64_t{1} << 28, "squares, and twice the length of a row in 32 bits, fit");
  for (const std::int64_t a : {a00, a01, a10, a11}) {
    if (a > kMax_q16 || a < -kMax_q16) return false;
  }
  const std::int64_t m00 = integer_sqrt(static_cast<std::uint64_t>(square(a00) + square(a01)));
  if (m00 < kOne_q16) return false;
  const std::int64_t m11 = (a00 * a11 - a01 * a10) / m00;
  if (m11 < kOne_q16) return false;
  e.m00_q16 = static_cast<std::int32_t>(m00);
  e.m10_q16 = static_cast<std::int32_t>((a00 * a10 + a01 * a11) / m00);
  e.m11_q16 = static_cast<std::int32_t>(m11);
  return true;
}

// How far the rays' offsets are from those of an ellipse: what is left of their power, and harmonics of corners.
void judge_scatter(const PerRay& offsets_q16, const Harmonic& centre, const Harmonic& shape, EdgeFit& fit) noexcept {
  std::int64_t sum = 0, power_q32 = 0;
  for (const std::int32_t offset : offsets_q16) sum += offset, power_q32 += square(offset);
  power_q32 -=
      square(sum) / kRays + kRays / 2 * (square(centre.a) + square(centre.b) + square(shape.a) + square(shape.b));
  constexpr int kUnknowns = 5;
  const std::int64_t scatter_q32 = std::max<std::int64_t>(power_q32, 0) / (kRays - kUnknowns);
  fit.roughness_q16 = static_cast<std::int32_t>(integer_sqrt(static_cast<std::uint64_t>(scatter_q32)));
  const Harmonic third = harmonic(offsets_q16, 3), fourth = harmonic(offsets_q16, 4);
  fit.corners_q16 = static_cast<std::int32_t>(integer_sqrt(
      static_cast<std::uint64_t>(square(third.a) + square(third.b) + square(fourth.a) + square(fourth.b))));
}

// One step: reads the rays in a window of +-half_window, moves the ellipse. Returns the edge's variance, Q16, in
// squared radii, or -1 where there is no edge all round.
std::int64_t improve(const ImageView& image, Inside inside, std::int32_t half_window_q16, EdgeFit& fit) noexcept {
  Ellipse& e = fit.ellipse;
  Samples samples;
  Profile profile;
  read_rays(image, e, half_window_q16, samples);
  if (!find_profile(samples, inside, profile) || !is_closed(samples, inside, profile)) return -1;
  const std::int64_t step_q16 = 2 * half_window_q16 / (kSamples - 1);
  PerRay offsets_q16 = ray_offsets(samples, profile);  // in samples, then in radii
  for (std::int32_t& offset : offsets_q16) offset = static_cast<std::int32_t>(offset * step_q16 >> kQ16);

  const Harmonic centre = harmonic(offsets_q16, 1), shape = harmonic(offsets_q16, 2);
  judge_scatter(offsets_q16, centre, shape, fit);
  fit.contrast_q4 = profile.contrast_q4;
  e.u_q16 += static_cast<std::int32_t>(e.m00_q16 * centre.a >> kQ16);
  e.v_q16 += static_cast<std::int32_t>((e.m10_q16 * centre.a + e.m11_q16 * centre.b) >> kQ16);
  const std::int64_t size_q16 = profile.position_q16 * step_q16 >> kQ16;
  if (!deform(e, size_q16 + shape.a, shape.b, size_q16 - shape.a)) return -1;
  return (profile.variance_q16 * step_q16 >> kQ16) * step_q16 >> kQ16;
}

// centre = M c, and each of c's variances is 2 / kRays of the scatter; the mean of those of u and v.
std::uint32_t centre_variance_q16(const EdgeFit& fit) noexcept {
  const Ellipse& e = fit.ellipse;
  const std::int64_t squares_q16 = (square(e.m00_q16) + square(e.m10_q16) + square(e.m11_q16)) >> kQ16;
  const std::int64_t variance_q16 = (squares_q16 / kRays) * (square(fit.roughness_q16) >> 8) >> 24;
  // Rays nearer than 2.2 px share pixels: their scatter is smaller than that of as many independent ones.
  constexpr std::int64_t kIndependent_px = 70;
  const std::int64_t perimeter_px = integer_sqrt(static_cast<std::uint64_t>(20 * squares_q16 >> kQ16));
  const std::int64_t honest_q16 =
      variance_q16 * kIndependent_px / std::clamp<std::int64_t>(perimeter_px, 1, kIndependent_px);
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(honest_q16, 1, 0xffffffff));
}

// Blur of variance s^2 moves an edge towards its centre of curvature by s^2 / (2 R). For an ellipse that is, to first
// order, undone by M <- M (1 + w M^T M / tr(M^T M)) with w the variance of the normalised edge.
bool undo_blur(Ellipse& e, std::int64_t width_q16) noexcept {
  const std::int64_t g00 = (square(e.m00_q16) + square(e.m10_q16)) >> kQ16;
  const std::int64_t g10 = (std::int64_t{e.m10_q16} * e.m11_q16) >> kQ16;
  const std::int64_t g11 = square(e.m11_q16) >> kQ16;
  const std::int64_t trace = g00 + g11;
  return deform(e, width_q16 * g00 / trace, width_q16 * g10 / trace, width_q16 * g11 / trace);
}

// A fit that wandered off has found some other edge.
bool is_near(const Ellipse& e, const Ellipse& seed) noexcept {
  const auto similar = [](std::int64_t a, std::int64_t b) { return 10 * a > 7 * b && 10 * a < 13 * b; };
  const std::int64_t radius_q16 = mean_radius_q16(seed);
  const std::int64_t du = e.u_q16 - seed.u_q16, dv = e.v_q16 - seed.v_q16;
  return 4 * (du * du + dv * dv) < radius_q16 * radius_q16 && similar(mean_radius_q16(e), radius_q16);
}

}  // namespace

bool fit_edge(const ImageView& image, Inside inside, std::int32_t reach_q16, const Ellipse& seed,
              EdgeFit& out) noexcept {
  EdgeFit fit{.ellipse = seed};
  std::int64_t width_q16 = 0;
  for (const std::int32_t reach_px : kReach_px) {
    const std::int64_t radius_q16 = mean_radius_q16(fit.ellipse);
    if (radius_q16 < kOne_q16) return false;
    const std::int64_t window_q16 = std::min<std::int64_t>(reach_q16, (std::int64_t{reach_px} << 32) / radius_q16);
    width_q16 = improve(image, inside, static_cast<std::int32_t>(window_q16), fit);
    if (width_q16 < 0 || !is_near(fit.ellipse, seed)) return false;
  }
  fit.centre_variance_q16 = centre_variance_q16(fit);
  if (!undo_blur(fit.ellipse, width_q16)) return false;
  out = fit;
  return true;
}

}  // namespace articam::vision
