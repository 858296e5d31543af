#include "core/vision/mark.hpp"

#include <cmath>

#include "core/vision/concentric.hpp"
#include "core/vision/edge_fit.hpp"
#include "core/vision/ellipse_shape.hpp"
#include "core/vision/fixed_point.hpp"
#include "core/vision/point_symmetry.hpp"

namespace articam::vision {
namespace {

constexpr std::int32_t percent_q16(int percent) noexcept { return percent * kOne_q16 / 100; }

// A share of the radius, and what noise and the pixel grid add to small marks, `times` as much.
bool is_an_ellipse(const EdgeFit& fit, int times) noexcept {
  const std::int64_t radius_q16 = mean_radius_q16(fit.ellipse);
  const auto allowed_q16 = [radius_q16](int percent, int hundredths_px) {
    return percent_q16(percent) + (std::int64_t{percent_q16(hundredths_px)} << kQ16) / radius_q16;
  };
  return fit.roughness_q16 < times * allowed_q16(4, 15) && fit.corners_q16 < times * allowed_q16(3, 8);
}

// The hole's size is the ratio's within half of what parts it from the nearest ratio that is none, a fifth; a blurred
// mark's is known less, its bias is up to 18 %. The hole's centre is near the ring's (perspective parts them by less),
// and it is about as light inside as around.
bool belong_together(const EdgeFit& outer, const EdgeFit& inner, std::int32_t ratio_q16) noexcept {
  const std::int64_t radius_q16 = mean_radius_q16(outer.ellipse), hole_q16 = mean_radius_q16(inner.ellipse);
  const std::int64_t expected_q16 = radius_q16 * ratio_q16 >> kQ16;
  const std::int64_t allowed_q16 = percent_q16((outer.flaws & kBlurred) != 0 ? 18 : 11);
  if (std::abs(hole_q16 - expected_q16) > expected_q16 * allowed_q16 >> kQ16) return false;
  const std::int64_t du = inner.ellipse.u_q16 - outer.ellipse.u_q16, dv = inner.ellipse.v_q16 - outer.ellipse.v_q16;
  if (36 * (du * du + dv * dv) > radius_q16 * radius_q16) return false;
  return outer.contrast_q4 < 3 * inner.contrast_q4 && inner.contrast_q4 < 2 * outer.contrast_q4;
}

void put(const EdgeFit& fit, MarkKind kind, Detection& out) noexcept {
  out = {.kind = kind,
         .flaws = fit.flaws,
         .blur_q8 = fit.blur_q8,
         .outer = fit.ellipse,
         .centre_variance_q24 = fit.centre_variance_q24,
         .axis_variance_q24 = fit.axis_variance_q24};
}

}  // namespace

bool measure_ring(const ImageView& image, const Ellipse& seed, std::int32_t ratio_q16, const Pinhole& camera,
                  int& budget, Detection& out) noexcept {
  EdgeFit outer, inner;
  if (!fit_edge(image, Inside::darker, Reading::full, (kOne_q16 - ratio_q16) / 2, seed, budget, outer) ||
      !is_an_ellipse(outer, 1))
    return false;
  const auto to_outer_q16 = static_cast<std::int32_t>((std::int64_t{kOne_q16} << kQ16) / ratio_q16) - kOne_q16;
  const std::int32_t reach_q16 = std::min(percent_q16(70), to_outer_q16 / 2);
  if (!fit_edge(image, Inside::lighter, Reading::plain, reach_q16, scaled(outer.ellipse, ratio_q16), budget, inner))
    return false;
  if (!is_an_ellipse(inner, 2) || !belong_together(outer, inner, ratio_q16)) return false;
  Centre centre;
  if (!join_centres(outer, inner, camera, ratio_q16, centre)) return false;
  weigh_symmetry(image, outer, ratio_q16, budget, centre);
  put(outer, MarkKind::ring, out);
  out.outer.u_q16 = centre.u_q16, out.outer.v_q16 = centre.v_q16;
  out.centre_variance_q24 = centre.variance_q24;
  out.inner = inner.ellipse;
  out.inner_centre_variance_q24 = inner.centre_variance_q24;
  out.inner_axis_variance_q24 = inner.axis_variance_q24;
  return true;
}

bool measure_dot(const ImageView& image, const Ellipse& seed, bool light, int& budget, Detection& out) noexcept {
  EdgeFit fit;
  if (!fit_edge(image, light ? Inside::lighter : Inside::darker, Reading::full, percent_q16(32), seed, budget, fit))
    return false;
  if (!is_an_ellipse(fit, 1)) return false;
  put(fit, light ? MarkKind::dot_light_on_dark : MarkKind::dot_dark_on_light, out);
  return true;
}

}  // namespace articam::vision
