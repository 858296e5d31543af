#include "core/vision/mark.hpp"

#include <algorithm>

#include "core/vision/edge_fit.hpp"
#include "core/vision/fixed_point.hpp"

namespace articam::vision {
namespace {

constexpr std::int32_t percent_q16(int percent) noexcept { return percent * kOne_q16 / 100; }

Ellipse moved(Ellipse e, Origin origin) noexcept {
  e.u_q16 += origin.u_px * kOne_q16;
  e.v_q16 += origin.v_px * kOne_q16;
  return e;
}

Ellipse scaled(Ellipse e, std::int32_t factor_q16) noexcept {
  const auto times = [factor_q16](std::int32_t m) {
    return static_cast<std::int32_t>(std::int64_t{m} * factor_q16 >> kQ16);
  };
  return {e.u_q16, e.v_q16, times(e.m00_q16), times(e.m10_q16), times(e.m11_q16)};
}

bool dark_at(const BitMask& mask, const Ellipse& e, int k, std::int32_t radius_q16) noexcept {
  const Ellipse s = scaled(e, radius_q16);
  const std::int64_t u = s.u_q16 + (std::int64_t{s.m00_q16} * ray_cos_q14(k) >> kQ14);
  const std::int64_t v =
      s.v_q16 + ((std::int64_t{s.m10_q16} * ray_cos_q14(k) + std::int64_t{s.m11_q16} * ray_sin_q14(k)) >> kQ14);
  const int u_px = std::clamp(static_cast<int>((u + kOne_q16 / 2) >> kQ16), 0, mask.width_px() - 1);
  const int v_px = std::clamp(static_cast<int>((v + kOne_q16 / 2) >> kQ16), 0, mask.height_px() - 1);
  return mask.row(v_px, Colour::dark).at(u_px);
}

// A share of the radius, and what noise and the pixel grid add to small marks.
bool is_an_ellipse(const EdgeFit& fit) noexcept {
  const std::int64_t radius_q16 = mean_radius_q16(fit.ellipse);
  const auto allowed_q16 = [radius_q16](int percent, int hundredths_px) {
    return percent_q16(percent) + (std::int64_t{percent_q16(hundredths_px)} << kQ16) / radius_q16;
  };
  return fit.roughness_q16 < allowed_q16(4, 15) && fit.corners_q16 < allowed_q16(3, 8);
}

// The hole's size within 18 % of the ratio, its centre near the ring's (perspective parts them by less), and about
// the same light inside as around.
bool belong_together(const EdgeFit& outer, const EdgeFit& inner, std::int32_t ratio_q16) noexcept {
  const std::int64_t radius_q16 = mean_radius_q16(outer.ellipse), hole_q16 = mean_radius_q16(inner.ellipse);
  const std::int64_t expected_q16 = radius_q16 * ratio_q16 >> kQ16;
  if (hole_q16 * 100 < expected_q16 * 82 || hole_q16 * 100 > expected_q16 * 118) return false;
  const std::int64_t du = inner.ellipse.u_q16 - outer.ellipse.u_q16, dv = inner.ellipse.v_q16 - outer.ellipse.v_q16;
  if (36 * (du * du + dv * dv) > radius_q16 * radius_q16) return false;
  return outer.contrast_q4 < 3 * inner.contrast_q4 && inner.contrast_q4 < 2 * outer.contrast_q4;
}

}  // namespace

bool find_ring(const ImageView& image, const BitMask& mask, Origin origin, const Region& region, std::int32_t ratio_q16,
               int& budget, Detection& out) noexcept {
  // the hole's share of the outline is ratio^2
  const std::int64_t hole = region.area - region.own;
  const std::int64_t expected_q16 = region.area * (std::int64_t{ratio_q16} * ratio_q16 >> kQ16);
  if (hole * kOne_q16 * 2 < expected_q16 || hole * kOne_q16 > 2 * expected_q16) return false;
  Ellipse seed;
  if (!ellipse_of(region, seed)) return false;
  if (dark_at(mask, seed, 0, 0)) return false;
  int dark = 0;
  for (int k = 0; k < kRays; k += kRays / 8) dark += dark_at(mask, seed, k, (kOne_q16 + ratio_q16) / 2);
  if (dark < 7) return false;

  EdgeFit outer, inner;
  budget -= kRowsPerFit;
  if (!fit_edge(image, Inside::darker, (kOne_q16 - ratio_q16) / 2, moved(seed, origin), outer)) return false;
  if (!is_an_ellipse(outer)) return false;
  const std::int32_t to_outer_q16 = static_cast<std::int32_t>((std::int64_t{kOne_q16} << kQ16) / ratio_q16) - kOne_q16;
  budget -= kRowsPerFit;
  const std::int32_t hole_reach_q16 = std::min(percent_q16(70), to_outer_q16 / 2);
  if (!fit_edge(image, Inside::lighter, hole_reach_q16, scaled(outer.ellipse, ratio_q16), inner)) return false;
  if (!belong_together(outer, inner, ratio_q16)) return false;
  out = {MarkKind::ring, outer.ellipse, inner.ellipse, outer.centre_variance_q16};
  return true;
}

bool find_dot(const ImageView& image, Origin origin, const Region& region, int& budget, Detection& out) noexcept {
  if (region.own * 100 < region.area * 96) return false;
  Ellipse seed;
  if (!ellipse_of(region, seed)) return false;
  const bool light = region.colour == Colour::light;
  EdgeFit fit;
  budget -= kRowsPerFit / 4;
  if (!fit_edge(image, light ? Inside::lighter : Inside::darker, percent_q16(32), moved(seed, origin), fit))
    return false;
  if (!is_an_ellipse(fit)) return false;
  out = {light ? MarkKind::dot_light_on_dark : MarkKind::dot_dark_on_light, fit.ellipse, {}, fit.centre_variance_q16};
  return true;
}

}  // namespace articam::vision
