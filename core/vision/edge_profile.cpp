#include "core/vision/edge_profile.hpp"

#include <algorithm>
#include <cmath>

namespace articam::vision {
namespace {

constexpr int kMiddle_q1 = kSamples - 1;  // twice the index of the radius 1
constexpr std::int32_t kMinContrast_q4 = 12 * 16;

// Rays are read so many at a time, in loops each of which does one thing, so that compilers make vectors of all but the
// loads.
constexpr int kRaysAtOnce = 8;
constexpr std::size_t kAtOnce = kRaysAtOnce * kSamples;
using Places = std::array<std::int32_t, kAtOnce>;

// What samples lie between: two pixels and the two below them, each pair's left one in the lower byte, and how far
// right and down of the first, Q8.
struct Corners {
  std::array<std::uint16_t, kAtOnce> above, below;
  std::array<std::int16_t, kAtOnce> right_q8, down_q8;

  void put(std::size_t i, const std::uint8_t* first, int right, std::ptrdiff_t down) noexcept {
    const std::uint8_t* second = first + down;
    above[i] = static_cast<std::uint16_t>(first[0] | first[right] << 8);
    below[i] = static_cast<std::uint16_t>(second[0] | second[right] << 8);
  }
};

// Bilinear, Q4. Q7 in between, so that differences fit 16 bits, and the upper halves of their products too.
void blend_q4(const Corners& corners, std::int16_t* __restrict out) noexcept {
  static_assert(255 << 7 < 1 << 15, "grey levels, Q7, and fractions, Q15, are signed words");
  const auto along_q7 = [](int pair, int f) {
    const int left = pair & 255, right = pair >> 8;
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(left * 256 + (right - left) * f) >> 1);
  };
  for (std::size_t i = 0; i < kAtOnce; ++i) {
    const std::int16_t top_q7 = along_q7(corners.above[i], corners.right_q8[i]);
    const auto more_q7 = static_cast<std::int16_t>(along_q7(corners.below[i], corners.right_q8[i]) - top_q7);
    const auto down_q15 = static_cast<std::int16_t>(corners.down_q8[i] * 128);
    const auto part_q6 = static_cast<std::int16_t>(more_q7 * down_q15 >> 16);
    const auto half_q6 = static_cast<std::int16_t>((top_q7 >> 1) + part_q6 + 2);
    out[i] = static_cast<std::int16_t>(half_q6 >> 2);
  }
}

// Of rays that lie wholly inside the image. 16 bits times 16 bits, which vector units have.
void find_inside(const ImageView& image, const Places& u_q16, const Places& v_q16, Corners& out) noexcept {
  std::array<std::int16_t, kAtOnce> row;
  std::array<std::int32_t, kAtOnce> offset;
  const auto stride = static_cast<std::int16_t>(image.stride_bytes);
  for (std::size_t i = 0; i < kAtOnce; ++i) row[i] = static_cast<std::int16_t>(v_q16[i] >> 16);
  for (std::size_t i = 0; i < kAtOnce; ++i) offset[i] = row[i] * stride + (u_q16[i] >> 16);
  for (std::size_t i = 0; i < kAtOnce; ++i) out.put(i, image.data + offset[i], 1, image.stride_bytes);
  for (std::size_t i = 0; i < kAtOnce; ++i) out.right_q8[i] = static_cast<std::int16_t>(u_q16[i] >> 8 & 255);
  for (std::size_t i = 0; i < kAtOnce; ++i) out.down_q8[i] = static_cast<std::int16_t>(v_q16[i] >> 8 & 255);
}

// Of any others: beyond the image its border goes on.
void find_anywhere(const ImageView& image, const Places& u_q16, const Places& v_q16, Corners& out) noexcept {
  for (std::size_t i = 0; i < kAtOnce; ++i) {
    const int u_q8 = std::clamp<int>(u_q16[i] >> 8, 0, (image.width_px - 1) << 8);
    const int v_q8 = std::clamp<int>(v_q16[i] >> 8, 0, (image.height_px - 1) << 8);
    out.right_q8[i] = static_cast<std::int16_t>(u_q8 & 255);
    out.down_q8[i] = static_cast<std::int16_t>(v_q8 & 255);
    out.put(i, image.row(v_q8 >> 8) + (u_q8 >> 8), out.right_q8[i] != 0, out.down_q8[i] != 0 ? image.stride_bytes : 0);
  }
}

// The ellipse, its window and one pixel more lie inside the image, whose stride fits find_inside().
bool reads_inside(const ImageView& image, const Ellipse& e, std::int32_t half_window_q16) noexcept {
  if (image.stride_bytes > 0x7fff) return false;
  const std::int64_t outer_q16 = kOne_q16 + half_window_q16;
  const std::int64_t du = (e.m00_q16 * outer_q16 >> kQ16) + 2 * kOne_q16;
  const std::int64_t m1 =
      std::int64_t{e.m10_q16 < 0 ? -e.m10_q16 : e.m10_q16} + e.m11_q16;  // not below the half height
  const std::int64_t dv = (m1 * outer_q16 >> kQ16) + 2 * kOne_q16;
  return e.u_q16 - du >= 0 && e.v_q16 - dv >= 0 && e.u_q16 + du < std::int64_t{image.width_px - 1} << kQ16 &&
         e.v_q16 + dv < std::int64_t{image.height_px - 1} << kQ16;
}

template <void (*find)(const ImageView&, const Places&, const Places&, Corners&) noexcept>
void read(const ImageView& image, const Ellipse& e, std::int32_t half_window_q16, RaySamples& out) noexcept {
  const std::int64_t step_q16 = 2 * half_window_q16 / (kSamples - 1);
  const std::int64_t first_q16 = kOne_q16 - half_window_q16;
  // Places are cut to Q8 below. Without this, all would be read 0.002 px too far to the left and above.
  constexpr std::int32_t kHalfOfStep_q16 = 1 << 7;
  const Wave& wave = wave_of(out.rays, 1);
  for (std::size_t first = 0; first < static_cast<std::size_t>(out.rays); first += kRaysAtOnce) {
    Places u_q16, v_q16;
    for (std::size_t i = 0, k = first; i < kAtOnce; ++k) {
      const std::int64_t c = wave.cos_q14[k], s = wave.sin_q14[k];
      const std::int64_t du_q16 = e.m00_q16 * c >> kQ14, dv_q16 = (e.m10_q16 * c + e.m11_q16 * s) >> kQ14;
      const auto first_u = e.u_q16 + kHalfOfStep_q16 + static_cast<std::int32_t>(du_q16 * first_q16 >> kQ16),
                 first_v = e.v_q16 + kHalfOfStep_q16 + static_cast<std::int32_t>(dv_q16 * first_q16 >> kQ16),
                 step_u = static_cast<std::int32_t>(du_q16 * step_q16 >> kQ16),
                 step_v = static_cast<std::int32_t>(dv_q16 * step_q16 >> kQ16);
      for (int j = 0; j < kSamples; ++j, ++i) u_q16[i] = first_u + j * step_u, v_q16[i] = first_v + j * step_v;
    }
    Corners corners;
    find(image, u_q16, v_q16, corners);
    std::uint8_t *const right = out.right_q8[first].data(), *const down = out.down_q8[first].data();
    for (std::size_t i = 0; i < kAtOnce; ++i) right[i] = static_cast<std::uint8_t>(corners.right_q8[i]);
    for (std::size_t i = 0; i < kAtOnce; ++i) down[i] = static_cast<std::uint8_t>(corners.down_q8[i]);
    blend_q4(corners, out.grey_q4[first].data());
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
    read<find_inside>(image, e, half_window_q16, out);
  else
    read<find_anywhere>(image, e, half_window_q16, out);
}

namespace {

// The derivative of the profile, weighted by its own steepness. Farther out it tells little of the edge, and what lies
// there of others. A threshold in its place would take samples in and out while the ellipse moves by hundredths of px.
PerSample steep_part(const PerSample& slope_q4) noexcept {
  PerSample filter = slope_q4;
  int steepest = 1;
  for (const int slope : filter) steepest = std::max(steepest, std::abs(slope));
  for (std::int16_t& slope : filter) slope = static_cast<std::int16_t>(slope * std::abs(slope) / steepest);
  return filter;
}

}  // namespace

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
  out.clipped = *low < samples.rays * kLeast_q4;
  out.saturated = *high > samples.rays * kMost_q4;

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
  out.filter_q4 = steep_part(out.slope_q4);
  return true;
}

int find_crossings(const RaySamples& samples, int sign, const EdgeProfile& profile, PerRay& crosses) noexcept {
  int weak = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(samples.rays); ++k) {
    const PerSample& grey_q4 = samples.grey_q4[k];
    const bool flat = 3 * sign * (grey_q4.back() - grey_q4.front()) < profile.contrast_q4;
    crosses[k] = flat ? std::int16_t{0} : std::int16_t{-1};
    weak += flat ? 1 : 0;
  }
  return weak;
}

}  // namespace articam::vision
