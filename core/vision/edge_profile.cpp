#include "core/vision/edge_profile.hpp"

#include <algorithm>

namespace articam::vision {
namespace {

constexpr int kMiddle_q1 = kSamples - 1;  // twice the index of the radius 1
constexpr std::int32_t kMinContrast_q4 = 12 * 16;

// Bilinear, Q4, between the pixels at p and their right and lower neighbours; fractions Q8.
inline std::int16_t blend_q4(const std::uint8_t* above, const std::uint8_t* below, int right, int fu, int fv) noexcept {
  const int top = above[0] * 256 + (above[right] - above[0]) * fu;
  const int bottom = below[0] * 256 + (below[right] - below[0]) * fu;
  return static_cast<std::int16_t>((top * 256 + (bottom - top) * fv + (1 << 11)) >> 12);
}

std::int16_t sample_inside_q4(const ImageView& image, std::int32_t u_q16, std::int32_t v_q16) noexcept {
  const std::uint8_t* above = image.row(v_q16 >> 16) + (u_q16 >> 16);
  return blend_q4(above, above + image.stride_bytes, 1, u_q16 >> 8 & 255, v_q16 >> 8 & 255);
}

// Beyond the image its border goes on.
std::int16_t sample_anywhere_q4(const ImageView& image, std::int32_t u_q16, std::int32_t v_q16) noexcept {
  const int u_q8 = std::clamp<int>(u_q16 >> 8, 0, (image.width_px - 1) << 8);
  const int v_q8 = std::clamp<int>(v_q16 >> 8, 0, (image.height_px - 1) << 8);
  const int fu = u_q8 & 255, fv = v_q8 & 255;
  const std::uint8_t* above = image.row(v_q8 >> 8) + (u_q8 >> 8);
  return blend_q4(above, above + (fv != 0 ? image.stride_bytes : 0), fu != 0, fu, fv);
}

// The ellipse, its window and one pixel more lie inside the image.
bool reads_inside(const ImageView& image, const Ellipse& e, std::int32_t half_window_q16) noexcept {
  const std::int64_t outer_q16 = kOne_q16 + half_window_q16;
  const std::int64_t du = (e.m00_q16 * outer_q16 >> kQ16) + 2 * kOne_q16;
  const std::int64_t m1 =
      std::int64_t{e.m10_q16 < 0 ? -e.m10_q16 : e.m10_q16} + e.m11_q16;  // not below the half height
  const std::int64_t dv = (m1 * outer_q16 >> kQ16) + 2 * kOne_q16;
  return e.u_q16 - du >= 0 && e.v_q16 - dv >= 0 && e.u_q16 + du < std::int64_t{image.width_px - 1} << kQ16 &&
         e.v_q16 + dv < std::int64_t{image.height_px - 1} << kQ16;
}

template <std::int16_t (*sample_q4)(const ImageView&, std::int32_t, std::int32_t) noexcept>
void read(const ImageView& image, const Ellipse& e, std::int32_t half_window_q16, RaySamples& out) noexcept {
  const std::int64_t step_q16 = 2 * half_window_q16 / (kSamples - 1);
  const std::int64_t first_q16 = kOne_q16 - half_window_q16;
  const Wave& wave = wave_of(out.rays, 1);
  for (int k = 0; k < out.rays; ++k) {
    const std::int64_t c = wave.cos_q14[static_cast<std::size_t>(k)], s = wave.sin_q14[static_cast<std::size_t>(k)];
    const std::int64_t du_q16 = e.m00_q16 * c >> kQ14, dv_q16 = (e.m10_q16 * c + e.m11_q16 * s) >> kQ14;
    std::int32_t u_q16 = e.u_q16 + static_cast<std::int32_t>(du_q16 * first_q16 >> kQ16);
    std::int32_t v_q16 = e.v_q16 + static_cast<std::int32_t>(dv_q16 * first_q16 >> kQ16);
    const auto step_u = static_cast<std::int32_t>(du_q16 * step_q16 >> kQ16),
               step_v = static_cast<std::int32_t>(dv_q16 * step_q16 >> kQ16);
    for (std::int16_t& grey_q4 : out.grey_q4[static_cast<std::size_t>(k)]) {
      grey_q4 = sample_q4(image, u_q16, v_q16);
      u_q16 += step_u, v_q16 += step_v;
    }
  }
}

}  // namespace

int rays_around(std::int64_t radius_q16) noexcept {
  return radius_q16 < 8 * kOne_q16 ? 32 : (radius_q16 < 24 * kOne_q16 ? 64 : 128);
}

void read_rays(const ImageView& image, const Ellipse& e, std::int32_t half_window_q16, int rays,
               RaySamples& out) noexcept {
  out.rays = rays;
  if (reads_inside(image, e, half_window_q16))
    read<sample_inside_q4>(image, e, half_window_q16, out);
  else
    read<sample_anywhere_q4>(image, e, half_window_q16, out);
}

bool find_profile(const RaySamples& samples, int sign, EdgeProfile& out) noexcept {
  static_assert(kMaxRays * 255 * 16 < 1 << 20, "bounds of the sums below");
  std::array<std::int32_t, kSamples> sum{};
  for (int k = 0; k < samples.rays; ++k) {
    const PerSample& grey = samples.grey_q4[static_cast<std::size_t>(k)];
    for (std::size_t j = 0; j < kSamples; ++j) sum[j] += grey[j];
  }
  std::array<std::int64_t, kSamples> slope{};  // over two samples, summed over the rays
  std::size_t i_steepest = 1;
  for (std::size_t j = 1; j + 1 < kSamples; ++j) {
    slope[j] = sum[j + 1] - sum[j - 1];
    if (sign * slope[j] > sign * slope[i_steepest]) i_steepest = j;
  }
  const std::int64_t steepest = sign * slope[i_steepest];
  const auto [low, high] = std::minmax_element(sum.begin(), sum.end());
  const std::int64_t range = *high - *low;
  out.contrast_q4 = static_cast<std::int32_t>(range / samples.rays);
  if (out.contrast_q4 < kMinContrast_q4 || sign * std::int64_t{sum.back() - sum.front()} * 2 < range) return false;

  constexpr std::int32_t kLeast_q4 = 2 * 16, kMost_q4 = 253 * 16;  // the mean of clipped noise is a little inside
  out.saturated = *low < samples.rays * kLeast_q4 || *high > samples.rays * kMost_q4;

  // The place is the centroid of the squared slope near the radius 1, where neighbouring edges reach least.
  std::int64_t weight = 0, first = 0;
  for (std::size_t j = 2; j < kSamples - 2; ++j) {
    const std::int64_t w = square(std::max<std::int64_t>(sign * slope[j], 0) >> 3);
    weight += w;
    first += w * (2 * static_cast<std::int64_t>(j) - kMiddle_q1);
  }
  if (weight == 0) return false;
  out.position_q16 = first * (kOne_q16 / 2) / weight;

  // A Gaussian edge of contrast C has the steepest slope C / (sigma sqrt(2 pi)); a difference over two samples widens
  // it by a box of that length, and d away from the edge it is less, which adds d^2. C^2 / (2 pi (slope / 2)^2) =
  // 0.6366 (C / slope)^2.
  constexpr std::int64_t kTwoOverPi_q16 = 41722, kOfDifference_q16 = kOne_q16 / 3;
  if (6 * steepest < range) return false;  // flatter than a ramp over all samples; bounds the variance
  const std::int64_t ratio_q16 = range * kOne_q16 / steepest;
  const std::int64_t off_q16 =
      out.position_q16 - (2 * static_cast<std::int64_t>(i_steepest) - kMiddle_q1) * kOne_q16 / 2;
  out.variance_q16 = std::max<std::int64_t>(
      0, (square(ratio_q16) >> kQ16) * kTwoOverPi_q16 / kOne_q16 - kOfDifference_q16 - (square(off_q16) >> kQ16));

  for (std::size_t j = 0; j < kSamples; ++j) {
    out.mean_q4[j] = static_cast<std::int16_t>(sum[j] / samples.rays);
    // With the next but one: two samples alone flatten an edge that is as narrow as they are.
    const std::int64_t slope_x12 = j >= 2 && j + 2 < kSamples ? 8 * slope[j] - (sum[j + 2] - sum[j - 2]) : 6 * slope[j];
    out.slope_q4[j] = static_cast<std::int16_t>(std::clamp<std::int64_t>(slope_x12 / (12 * samples.rays), -4080, 4080));
  }
  return true;
}

int count_weak(const RaySamples& samples, int sign, const EdgeProfile& profile) noexcept {
  int weak = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(samples.rays); ++k)
    weak += crosses(samples.grey_q4[k], sign, profile) ? 0 : 1;
  return weak;
}

}  // namespace articam::vision
