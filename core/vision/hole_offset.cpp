#include "core/vision/hole_offset.hpp"

#include <algorithm>
#include <cmath>

#include "core/vision/ellipse_shape.hpp"
#include "core/vision/fixed_point.hpp"

namespace articam::vision {
namespace {

constexpr int kQ24 = 24;
constexpr std::int64_t kOne = 1 << kQ24;  // whatever has no suffix below has no unit and is Q24, below 32

constexpr std::int64_t times(std::int64_t a, std::int64_t b) noexcept { return a * b >> kQ24; }

std::int64_t root_of(std::int64_t a) noexcept { return integer_sqrt(std::max<std::int64_t>(a, 0) << kQ24); }

std::int32_t to_q16(double px) noexcept {
  return static_cast<std::int32_t>(std::clamp(px, -32767.0, 32767.0) * kOne_q16);
}

}  // namespace

Pinhole pinhole_of(const CameraParameters& camera) noexcept {
  const bool distorts =
      std::any_of(camera.distortion.begin(), camera.distortion.end(), [](double k) { return k != 0; });
  const double focal_px = std::sqrt(camera.fx_px * camera.fy_px);
  if (!(focal_px * kOne_q16 >= kMinFocal_q16)) return {};  // also a NaN
  return {to_q16(focal_px), to_q16(camera.cx_px), to_q16(camera.cy_px), distorts ? kOne_q16 / 2 : kOne_q16 / 512};
}

Pinhole likely_pinhole(int width_px, int height_px) noexcept {
  const auto half_q16 = [](int size_px) { return (size_px - 1) * (kOne_q16 / 2); };
  return {std::max(width_px * (kOne_q16 / 5 * 4), kMinFocal_q16), half_q16(width_px), half_q16(height_px),
          kOne_q16 / 4};
}

bool hole_offset(const Ellipse& ring, const Pinhole& camera, std::int32_t ratio_q16, HoleOffset& out) noexcept {
  constexpr std::int64_t kFarthest = 37 * kOne / 10;
  const auto on_plane = [&camera](std::int32_t px_q16, std::int32_t middle_q16) {
    return ((std::int64_t{px_q16} - middle_q16) << kQ24) / camera.focal_q16;
  };
  const std::int64_t x = on_plane(ring.u_q16, camera.u_q16), y = on_plane(ring.v_q16, camera.v_q16);
  if (std::abs(x) > kFarthest || std::abs(y) > kFarthest) return false;

  // The shape as a share of its trace.
  const std::int64_t trace_q16 = 2 * mean_square_q16(ring);
  if (trace_q16 <= 0) return false;
  const std::int64_t s00 = (square(ring.m00_q16) >> kQ16 << kQ24) / trace_q16, s11 = kOne - s00;
  const std::int64_t s10 = (std::int64_t{ring.m00_q16} * ring.m10_q16 >> kQ16 << kQ24) / trace_q16;

  // I + X X^T, and what is of second order in the size where m is small.
  const std::int64_t xx = times(x, x), xy = times(x, y), yy = times(y, y), length2 = kOne + xx + yy;
  const std::int64_t trace = ((trace_q16 << 20) / camera.focal_q16 << 20) / camera.focal_q16;
  const std::int64_t second = (std::min(trace, kOne) << kQ24) / length2 * kOne / (length2 + kOne);
  const std::int64_t b00 = kOne + xx + times(yy, second), b10 = xy - times(xy, second);
  const std::int64_t b11 = kOne + yy + times(xx, second);

  // rho^2 as a share of the trace is the larger root of  T r^2 - t r + det S = 0, its discriminant without
  // cancellation.
  const std::int64_t T = times(b00, b11) - times(b10, b10);
  const std::int64_t t = times(b11, s00) - 2 * times(b10, s10) + times(b00, s11);
  const std::int64_t discriminant = times(times(b11, s00) - times(b00, s11), times(b11, s00) - times(b00, s11)) +
                                    4 * times(times(b11, s10) - times(b10, s11), times(b00, s10) - times(b10, s00));
  const std::int64_t rho2 = std::max<std::int64_t>(((t + root_of(discriminant)) << (kQ24 - 1)) / T, 1);

  // m m^T = I + X X^T - S / rho^2; its larger diagonal element tells m best.
  const std::int64_t m00 = b00 - (s00 << kQ24) / rho2, m10 = b10 - (s10 << kQ24) / rho2;
  const std::int64_t m11 = b11 - (s11 << kQ24) / rho2;
  const std::int64_t larger = std::max<std::int64_t>(root_of(std::max(m00, m11)), 1);
  const std::int64_t other = std::clamp((m10 << kQ24) / larger, -larger, larger);
  const std::int64_t m0 = m00 > m11 ? larger : other, m1 = m00 > m11 ? other : larger;
  const std::int64_t mx = times(m0, x) + times(m1, y);
  const std::int64_t along = (mx << kQ24) / T;
  const std::int64_t across = (root_of(times(T, kOne - times(m0, m0) - times(m1, m1)) + times(mx, mx)) << kQ24) / T;

  const std::int64_t rho2_q16 = times(rho2, trace_q16);
  const std::int64_t scale_q16 = rho2_q16 * (kOne_q16 - (square(ratio_q16) >> kQ16)) / camera.focal_q16;
  const auto px_q16 = [scale_q16](std::int64_t q24) { return static_cast<std::int32_t>(times(scale_q16, q24)); };
  out = {px_q16(times(m0, along) - x),
         px_q16(times(m1, along) - y),
         px_q16(times(m0, across)),
         px_q16(times(m1, across)),
         static_cast<std::int32_t>(scale_q16),
         static_cast<std::int32_t>(integer_sqrt(rho2_q16 << kQ16))};
  return true;
}

}  // namespace articam::vision
