#include "core/vision/opposite_points.hpp"

#include <algorithm>

#include "core/vision/ellipse_shape.hpp"

namespace articam::vision {
namespace {

// S = even + c2 cos 2t + s2 sin 2t + c4 cos 4t + s4 sin 4t at each sample of a window, Q4 grey.
struct Harmonics {
  Lane even{}, c2{}, s2{}, c4{}, s4{};
};

Harmonics harmonics_of(const RaySamples& samples) noexcept {
  static_assert(2LL * 255 * 16 * (1 << (kQ14 - 4)) * kMaxRays / 2 < std::int64_t{1} << 31, "sums fit");
  const Wave &twice = wave_of(samples.rays, 2), &fourfold = wave_of(samples.rays, 4);
  const auto half = static_cast<std::size_t>(samples.rays / 2);
  Harmonics h;
  for (std::size_t k = 0; k < half; ++k) {
    const PerSample &here = samples.grey_q4[k], &there = samples.grey_q4[k + half];
    for (std::size_t j = 0; j < kSamples; ++j) {
      const std::int32_t both = here[j] + there[j];
      h.even[j] += both;
      h.c2[j] += both * twice.cos_q14[k] >> 4;
      h.s2[j] += both * twice.sin_q14[k] >> 4;
      h.c4[j] += both * fourfold.cos_q14[k] >> 4;
      h.s4[j] += both * fourfold.sin_q14[k] >> 4;
    }
  }
  const std::int32_t rays = samples.rays;
  for (std::size_t j = 0; j < kSamples; ++j) h.even[j] /= rays;
  for (Lane* wave : {&h.c2, &h.s2, &h.c4, &h.s4})
    for (std::int32_t& x : *wave) x /= rays << (kQ14 - 5);
  return h;
}

// How they grow over two samples; 0 at both ends.
Harmonics growth_of(const Harmonics& h) noexcept {
  const auto growth = [](const Lane& x) {
    Lane out{};
    for (std::size_t j = 1; j + 1 < kSamples; ++j) out[j] = x[j + 1] - x[j - 1];
    return out;
  };
  return {growth(h.even), growth(h.c2), growth(h.s2), growth(h.c4), growth(h.s4)};
}

// Not inlined, so that it and read_rays() use the same stack.
[[gnu::noinline]] OppositeSums sums_of(const RaySamples& samples, int first_step) noexcept {
  constexpr std::int32_t kMostSlope_q3 = 1 << 11;  // and grey level
  constexpr std::int64_t kMost_q3 = kMostSlope_q3 * 3 / 2, kMost_q4 = 255 * 16, kPairs = kMaxRays / 2;  // of a, of D
  static_assert(std::max(kMost_q3, kMost_q4) * std::max(kMost_q3, kMost_q4) * kPairs < std::int64_t{1} << 31);
  const Wave &once = wave_of(samples.rays, 1), &twice = wave_of(samples.rays, 2), &fourfold = wave_of(samples.rays, 4);
  const auto half = static_cast<std::size_t>(samples.rays / 2);
  const Harmonics h = harmonics_of(samples), outwards = growth_of(h);
  Lane inverse_q12{};
  for (std::size_t j = 1; j < kSamples; ++j) inverse_q12[j] = (1 << 12) / (first_step + static_cast<int>(j));
  OppositeSums sums;
  for (std::size_t k = 0; k < half; ++k) {
    const PerSample &here = samples.grey_q4[k], &there = samples.grey_q4[k + half];
    const std::int32_t cos1 = once.cos_q14[k], sin1 = once.sin_q14[k], cos2 = twice.cos_q14[k], sin2 = twice.sin_q14[k],
                       cos4 = fourfold.cos_q14[k], sin4 = fourfold.sin_q14[k];
    for (std::size_t j = 0; j < kSamples; ++j) {
      const std::int32_t S_q18 =
          (h.even[j] << kQ14) + h.c2[j] * cos2 + h.s2[j] * sin2 + h.c4[j] * cos4 + h.s4[j] * sin4;
      const std::int32_t out_q18 = (outwards.even[j] << kQ14) + outwards.c2[j] * cos2 + outwards.s2[j] * sin2 +
                                   outwards.c4[j] * cos4 + outwards.s4[j] * sin4;
      const std::int32_t round_q18 = 2 * (h.s2[j] * cos2 - h.c2[j] * sin2) + 4 * (h.s4[j] * cos4 - h.c4[j] * sin4);
      const std::int32_t out_q3 = std::clamp(out_q18 >> 16, -kMostSlope_q3, kMostSlope_q3);
      const std::int32_t round_q3 = std::clamp((round_q18 >> 14) * inverse_q12[j] >> 13, -kMostSlope_q3, kMostSlope_q3);
      const std::int32_t a = (cos1 * out_q3 - sin1 * round_q3) >> kQ14, b = (sin1 * out_q3 + cos1 * round_q3) >> kQ14;
      const std::int32_t S_q3 = std::clamp(S_q18 >> 15, -kMostSlope_q3, kMostSlope_q3);
      const std::int32_t x = cos1 * S_q3 >> kQ14, y = sin1 * S_q3 >> kQ14;
      const std::int32_t D = here[j] - there[j];
      sums.aa[j] += a * a, sums.ab[j] += a * b, sums.bb[j] += b * b;
      sums.xx[j] += x * x, sums.xy[j] += x * y, sums.yy[j] += y * y;
      sums.ax[j] += a * x, sums.ay[j] += a * y, sums.bx[j] += b * x, sums.by[j] += b * y;
      sums.aD[j] += a * D, sums.bD[j] += b * D, sums.xD[j] += x * D, sums.yD[j] += y * D, sums.DD[j] += D * D;
    }
  }
  return sums;
}

}  // namespace

OppositePoints::OppositePoints(const ImageView& image, const Ellipse& ring, int rays, int steps) noexcept {
  for (std::size_t k = 0; k < static_cast<std::size_t>(windows_of(steps)); ++k) {
    constexpr int kLength = kSamples - 1;
    const int twice_middle = 2 * kFirst[k] + kLength;
    RaySamples samples;
    read_rays(image, scaled(ring, twice_middle * kStep_q16 / 2), kLength * kOne_q16 / twice_middle, rays, samples);
    windows_[k] = sums_of(samples, kFirst[k]);
  }
}

}  // namespace articam::vision
