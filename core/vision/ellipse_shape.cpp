#include "core/vision/ellipse_shape.hpp"

#include <algorithm>
#include <bit>

#include "core/config.hpp"
#include "core/vision/fixed_point.hpp"

namespace articam::vision {

namespace {
constexpr std::int64_t kMax_q16 = std::int64_t{2} * std::max(kMaxImageWidth_px, kMaxImageHeight_px) * kOne_q16;
static_assert(kMax_q16 < std::int64_t{1} << 28, "squares, and twice the length of a row in 32 bits, fit");
}  // namespace

std::int64_t mean_radius_q16(const Ellipse& e) noexcept { return integer_sqrt(std::int64_t{e.m00_q16} * e.m11_q16); }

// The trace of M M^T is the sum of the squared semi-axes.
std::int64_t mean_square_q16(const Ellipse& e) noexcept {
  return (square(e.m00_q16) + square(e.m10_q16) + square(e.m11_q16)) >> (kQ16 + 1);
}

// The squared semi-axes are the eigenvalues of M M^T: half its trace, and the root of what that exceeds det^2 by.
std::int64_t minor_q16(const Ellipse& e) noexcept {
  const std::int64_t mean_q16 = mean_square_q16(e), det_q16 = std::int64_t{e.m00_q16} * e.m11_q16 >> kQ16;
  const int down = mean_q16 >> 30 != 0 ? 8 : 0;  // squares fit
  const std::int64_t gap_q16 = integer_sqrt(square(mean_q16 >> down) - square(det_q16 >> down)) << down;
  return integer_sqrt(std::max<std::int64_t>(1, mean_q16 - gap_q16) << kQ16);
}

std::int64_t major_square_q16(const Ellipse& e) noexcept {
  return 2 * mean_square_q16(e) - (square(minor_q16(e)) >> kQ16);
}

std::int64_t in_px_q24(const Ellipse& e, std::int64_t variance_q40) noexcept {
  const std::int64_t square_q16 = mean_square_q16(e);
  const int down = std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(square_q16))) - 24);
  return (square_q16 >> down) * std::min(variance_q40, std::int64_t{1} << 38) >> (kQ16 + 16 - down);
}

std::uint32_t to_variance_q24(std::int64_t variance_q24) noexcept {
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(variance_q24, 1, 0xffffffff));
}

Ellipse scaled(Ellipse e, std::int64_t factor_q16) noexcept {
  const auto times = [factor_q16](std::int32_t m) { return static_cast<std::int32_t>(m * factor_q16 >> kQ16); };
  return {e.u_q16, e.v_q16, times(e.m00_q16), times(e.m10_q16), times(e.m11_q16)};
}

bool deform(Ellipse& e, std::int64_t s00_q16, std::int64_t s10_q16, std::int64_t s11_q16) noexcept {
  const std::int64_t a00 = e.m00_q16 + (e.m00_q16 * s00_q16 >> kQ16), a01 = e.m00_q16 * s10_q16 >> kQ16;
  const std::int64_t a10 = e.m10_q16 + ((e.m10_q16 * s00_q16 + e.m11_q16 * s10_q16) >> kQ16);
  const std::int64_t a11 = e.m11_q16 + ((e.m10_q16 * s10_q16 + e.m11_q16 * s11_q16) >> kQ16);
  for (const std::int64_t a : {a00, a01, a10, a11}) {
    if (a > kMax_q16 || a < -kMax_q16) return false;
  }
  const std::int64_t m00 = integer_sqrt(square(a00) + square(a01));
  if (m00 < kOne_q16) return false;
  const std::int64_t m11 = (a00 * a11 - a01 * a10) / m00;
  if (m11 < kOne_q16) return false;
  e.m00_q16 = static_cast<std::int32_t>(m00);
  e.m10_q16 = static_cast<std::int32_t>((a00 * a10 + a01 * a11) / m00);
  e.m11_q16 = static_cast<std::int32_t>(m11);
  return true;
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

}  // namespace articam::vision
