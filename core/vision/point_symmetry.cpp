#include "core/vision/point_symmetry.hpp"

#include <algorithm>

#include "core/vision/ellipse_shape.hpp"
#include "core/vision/fixed_point.hpp"
#include "core/vision/opposite_points.hpp"
#include "core/vision/symmetric_fit.hpp"

namespace articam::vision {
namespace {

constexpr std::int64_t kMost_q40 = std::int64_t{1} << 36;  // a quarter of a radius, squared

// What an ellipse and its edge are like.
struct Ring {
  std::int64_t major_q16, flat_q16;  // semi-axis, px; how much shorter the other is, as a share
  std::int64_t blur_q8;              // px
  explicit Ring(const EdgeFit& outer) noexcept
      : major_q16(integer_sqrt(major_square_q16(outer.ellipse) << kQ16)), blur_q8(outer.blur_q8) {
    flat_q16 = kOne_q16 - (minor_q16(outer.ellipse) << kQ16) / major_q16;
  }
  bool has_its_hole_within(const Shift& hole_q24, std::int64_t px_q16) const noexcept {
    const std::int64_t most_q24 = (px_q16 << 24) / major_q16;
    return std::max(std::abs(hole_q24.a), std::abs(hole_q24.b)) < most_q24;
  }
  // The share of what is left that moves the centre. The other is what blending does to narrow edges, and to flat
  // rings; and c is nearer to the edges' answer than noise would have it, because noise in S makes slopes look steeper.
  // Found by measuring rendered rings of 12 to 31 px under noise of 4 and blur of 0.7 to 2.8 px, tilted by up to 60
  // degrees.
  std::int64_t noise_share_q8() const noexcept {
    const std::int64_t by_blur_q8 = std::max<std::int64_t>(56, 236 - 97 * 256 / blur_q8);
    const std::int64_t by_flatness_q16 =
        (square(flat_q16) >> kQ16) * (290 + std::min<std::int64_t>(blur_q8, 512) / 2) >> 8;
    return by_blur_q8 * std::max<std::int64_t>(kOne_q16 - by_flatness_q16, kOne_q16 / 4) >> kQ16;
  }
};

// Steps are not longer than 1.2 of the edge's width: longer ones would not show its slope. The mean of the squared axes
// tells that of most marks.
bool is_sampled_finely(const EdgeFit& outer) noexcept {
  const auto is_fine = [&outer](std::int64_t square_q16) {
    return 100 * ((square_q16 * kStep_q16 >> kQ16) * kStep_q16 >> kQ16) <= 144 * square(outer.blur_q8);
  };
  return is_fine(mean_square_q16(outer.ellipse)) && is_fine(major_square_q16(outer.ellipse));
}

struct Found {
  Shift centre_q24;  // radii
  std::int64_t variance_q40;
};

// Noise of a pixel is 9/4 of a sample's, which is blended of four. A sample at n steps stands for n step^2 2 pi / rays
// of the unit disc, so c has in radii the variance  9 / 4 share rest / area W^-1 / (pi |M|),  rest being what is left
// of all D / 2 when c is known. The trace of W^-1 is that of W by its determinant; half of it is each coordinate's.
bool find_centre(const SymmetricFit& fit, const Ring& ring, const Ellipse& e, Found& out) noexcept {
  Shift c;
  std::int64_t rest_q10;
  if (!fit.solve(c, rest_q10)) return false;
  constexpr std::int64_t kMost = std::int64_t{1} << 42;
  constexpr std::int64_t kUnit_q20 = 375503;  // 9 / 4 / 2 / pi
  const std::int64_t area_q8 = std::int64_t{e.m00_q16} * e.m11_q16 >> 24;
  const std::int64_t by_area_q10 = std::min(rest_q10 * ring.noise_share_q8() / area_q8, kMost);
  // The trace of W, Q6, by its determinant, Q12 less 16 bits, is Q10.
  const std::int64_t by_slopes_q20 = std::min(by_area_q10 * fit.W.trace() / (fit.W.det() >> 16), kMost);
  out = {{c.a * kStep_q16 >> 8, c.b * kStep_q16 >> 8},
         std::min(by_slopes_q20 * (kUnit_q20 / fit.area) >> fit.down, kMost_q40)};
  return true;
}

// What the hole's offset does: circles of radius r are moved by (1 - r^2) o. What is not known of it counts as in even
// light.
struct Offset {
  Shift o_q16;  // steps
  std::int64_t variance_q40;
};
Offset offset_of(const OppositePoints& points, const Centre& known, std::int32_t ratio_q16) noexcept {
  const std::int64_t band_q16 = kOne_q16 - (square(ratio_q16) >> kQ16);
  const auto steps_q16 = [band_q16](std::int64_t q24) { return (q24 << 24) / (band_q16 * kStep_q16); };
  const std::int64_t share_q16 = share_of_offset_q16(points) * kOne_q16 / band_q16;
  return {{steps_q16(known.hole_q24.a), steps_q16(known.hole_q24.b)},
          std::min(known.hole_variance_q40, kMost_q40) / 2 * (square(share_q16) >> kQ16) >> kQ16};
}

// In px, from the centre that the edges tell.
struct Move {
  std::int64_t u_q16{}, v_q16{}, variance_q24{};
};

// Where more is left than twice what the edges claim, or it is farther from their answer than four times what both
// claim, they keep it: something hides in the ring.
Move in_px(const Found& found, const Ellipse& e, std::int64_t claimed_q24) noexcept {
  const std::int64_t variance_q24 = in_px_q24(e, found.variance_q40);
  const auto [a, b] = found.centre_q24;
  const Move move{e.m00_q16 * a >> 24, (e.m10_q16 * a + e.m11_q16 * b) >> 24, variance_q24};
  const std::int64_t move_q24 = (square(move.u_q16) + square(move.v_q16)) >> 8;
  const bool hides = variance_q24 > 2 * claimed_q24 || move_q24 > 32 * (variance_q24 + claimed_q24);
  return hides ? Move{0, 0, claimed_q24} : move;
}

// Moves the edges' answer to the mean of both by how likely they are.
void apply(const Move& even, const Move& any, Centre& io) noexcept {
  const std::int64_t uneven_q16 = io.uneven_q16, unsure_q16 = uneven_q16 * (kOne_q16 - uneven_q16) >> kQ16;
  const auto mixed = [uneven_q16](std::int64_t e, std::int64_t a) { return e + ((a - e) * uneven_q16 >> kQ16); };
  const std::int64_t apart2_q32 = square(any.u_q16 - even.u_q16) + square(any.v_q16 - even.v_q16);
  io.u_q16 += static_cast<std::int32_t>(mixed(even.u_q16, any.u_q16));
  io.v_q16 += static_cast<std::int32_t>(mixed(even.v_q16, any.v_q16));
  io.variance_q24 =
      to_variance_q24(mixed(even.variance_q24, any.variance_q24) + ((apart2_q32 / 2 >> 8) * unsure_q16 >> kQ16));
}

}  // namespace

void weigh_symmetry(const ImageView& image, const EdgeFit& outer, std::int32_t ratio_q16, int& budget,
                    Centre& io) noexcept {
  if (!io.edges_agree || (outer.flaws & kOccluded) != 0 || !is_sampled_finely(outer)) return;
  // Blur mixes circles, so that (1 - r^2) o holds only where perspective parts them by little: on the border, which is
  // farthest from the hole, by less.
  const Ring seen(outer);
  if (!seen.has_its_hole_within(io.hole_q24, kOne_q16 / 2)) return;
  const bool light_counts = 16 * io.uneven_q16 > kOne_q16 && seen.has_its_hole_within(io.hole_q24, kOne_q16 / 7);
  const int steps = light_counts ? kStepsWithBorder : kStepsInRing;
  Ellipse ring = outer.ellipse;
  ring.u_q16 = io.u_q16, ring.v_q16 = io.v_q16;
  const int rays = rays_around(mean_radius_q16(ring));
  const OppositePoints points(image, ring, rays, steps);
  budget -= OppositePoints::windows_of(steps) * (kRaysPerPass + rays) * kLooksPerRay;

  const Offset offset = offset_of(points, io, ratio_q16);
  const std::int64_t claimed_q24 = io.variance_q24;
  Move even{0, 0, claimed_q24}, any = even;
  Found found;
  if (find_centre(fit_in_even_light(points, offset.o_q16), seen, ring, found)) {
    found.variance_q40 += offset.variance_q40;
    even = in_px(found, ring, claimed_q24);
  }
  SymmetricFit fit;
  if (light_counts && fit_in_any_light(points, offset.o_q16, fit) && find_centre(fit, seen, ring, found)) {
    found.variance_q40 = found.variance_q40 * 3 / 2 + offset.variance_q40;  // measured, as Ring::noise_share_q8()
    any = in_px(found, ring, claimed_q24);
  }
  apply(even, any, io);
}

}  // namespace articam::vision
