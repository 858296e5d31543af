#include "core/vision/point_symmetry.hpp"

#include <algorithm>
#include <bit>

#include "core/vision/ellipse_shape.hpp"
#include "core/vision/fixed_point.hpp"
#include "core/vision/opposite_points.hpp"

namespace articam::vision {
namespace {

struct Matrix2 {
  std::int64_t aa{}, ab{}, bb{};
  Shift operator*(const Shift& x) const noexcept { return {aa * x.a + ab * x.b, ab * x.a + bb * x.b}; }
};

// What is left of (D / 2)^2, Q10, when the centre moves by c and circles of radius r by (1 - r^2) o more, in steps,
// Q16.
std::int64_t rest_q10(const OppositePoints& points, const Shift& c, const Shift& o) noexcept {
  std::int64_t sum = 0;
  points.for_each([&](const OppositeSums& s, std::size_t j, std::int64_t i, std::int64_t inside_q16) {
    const std::int64_t a = c.a + (o.a * inside_q16 >> kQ16), b = c.b + (o.b * inside_q16 >> kQ16);
    const std::int64_t linear_q24 = 2 * (a * s.aD[j] + b * s.bD[j]);
    const std::int64_t square_q22 =
        (a * a >> kQ16) * s.aa[j] + 2 * (a * b >> kQ16) * s.ab[j] + (b * b >> kQ16) * s.bb[j];
    sum += i * (s.DD[j] + (linear_q24 >> 14) + (square_q22 >> 12));
  });
  return std::max<std::int64_t>(sum, 1);
}

// The least squares of c, in steps, Q16: W c = -(B + V o).
struct Equations {
  Matrix2 W, V;
  Shift B;
  int down{};  // what W is shifted by below, so that products fit

  explicit Equations(const OppositePoints& points) noexcept {
    points.for_each([this](const OppositeSums& s, std::size_t j, std::int64_t i, std::int64_t inside_q16) {
      const std::int64_t of_hole_q16 = i * inside_q16;
      W.aa += i * s.aa[j], W.ab += i * s.ab[j], W.bb += i * s.bb[j];
      V.aa += of_hole_q16 * s.aa[j] >> kQ16, V.ab += of_hole_q16 * s.ab[j] >> kQ16;
      V.bb += of_hole_q16 * s.bb[j] >> kQ16;
      B.a += i * s.aD[j] << 14, B.b += i * s.bD[j] << 14;
    });
    down = std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(W.aa + W.bb))) - 20);
  }
  Matrix2 w() const noexcept { return {W.aa >> down, W.ab >> down, W.bb >> down}; }
  // False where the slopes do not tell, or c is beyond a step.
  bool solve(const Shift& o, Shift& c) const noexcept {
    constexpr std::int64_t kMost = std::int64_t{1} << 38;  // four steps
    const Matrix2 m = w();
    const std::int64_t det = m.aa * m.bb - m.ab * m.ab;
    const Shift Vo = V * o, right{-(B.a + Vo.a) >> down, -(B.b + Vo.b) >> down};
    if (m.aa + m.bb < 1 << 14 || 32 * det <= square(m.aa + m.bb) || std::abs(right.a) >= kMost ||
        std::abs(right.b) >= kMost)
      return false;
    c = {(m.bb * right.a - m.ab * right.b) / det, (m.aa * right.b - m.ab * right.a) / det};
    return square(c.a) + square(c.b) <= square(kOne_q16);
  }
};

// What an ellipse and its edge are like.
struct Ring {
  std::int64_t major_q16, flat_q16;  // semi-axis, px; how much shorter the other is, as a share
  std::int64_t blur_q8;              // px
  explicit Ring(const EdgeFit& outer) noexcept : blur_q8(std::max<std::int64_t>(outer.blur_q8, 1)) {
    const std::int64_t minor = minor_q16(outer.ellipse);
    major_q16 = integer_sqrt((2 * mean_square_q16(outer.ellipse) << kQ16) - minor * minor);
    flat_q16 = kOne_q16 - (minor << kQ16) / std::max(major_q16, minor);
  }
  bool is_sampled_finely() const noexcept {
    return 10 * (major_q16 * kStep_q16 >> kQ16) <= 12 * (blur_q8 << (kQ16 - 8));
  }
  // Where perspective parts circles by more, (1 - r^2) o is not what blur makes of it.
  bool has_its_hole_in_the_middle(const Shift& hole_q24) const noexcept {
    const std::int64_t half_px_q24 = (std::int64_t{1} << (24 + kQ16 - 1)) / std::max<std::int64_t>(major_q16, kOne_q16);
    return std::max(std::abs(hole_q24.a), std::abs(hole_q24.b)) < half_px_q24;
  }
  // The share of what rays do not have in common that moves the centre. The rest is what blending does to narrow edges,
  // and to flat rings. Found by measuring rendered rings of 12 to 31 px under blur of 0.7 to 2 px, tilted by up to 60
  // degrees.
  std::int64_t noise_share_q8() const noexcept {
    const std::int64_t by_blur_q8 = std::max<std::int64_t>(56, 236 - 97 * 256 / blur_q8);
    const std::int64_t by_flatness_q16 =
        (square(flat_q16) >> kQ16) * (290 + std::min<std::int64_t>(blur_q8, 512) / 2) >> 8;
    return by_blur_q8 * std::max<std::int64_t>(kOne_q16 - by_flatness_q16, kOne_q16 / 4) >> kQ16;
  }
};

struct Found {
  Shift centre_q24;  // radii
  std::int64_t variance_q40;
};

// Noise of a pixel is 9/4 of a sample's, which is blended of four. With n steps a sample stands for n step^2 2 pi /
// rays of the unit disc, all for 78 pi step^2 in half a turn, and c has the variance 9 / 4 share rest / 78 W^-1 / (pi
// |M|)  in radii.
std::int64_t variance_q40(const Equations& equations, std::int64_t rest_q10, const Ring& ring,
                          const Ellipse& e) noexcept {
  constexpr std::int64_t kMost = std::int64_t{1} << 42;
  constexpr std::int64_t kUnit = 4814;  // 9 / 4 / 78 / pi / 2, Q(40 + 6 - 26)
  const std::int64_t area_q8 = std::max<std::int64_t>(std::int64_t{e.m00_q16} * e.m11_q16 >> 24, 1 << 8);
  const std::int64_t by_area_q10 = std::min(rest_q10 * ring.noise_share_q8() / area_q8, kMost);
  const Matrix2 w = equations.w();
  const std::int64_t det_q16 = std::max<std::int64_t>((w.aa * w.bb - w.ab * w.ab) >> 16, 1);
  return std::min(by_area_q10 * (w.aa + w.bb) / det_q16, kMost) * kUnit >> equations.down;
}

bool find_centre(const OppositePoints& points, const EdgeFit& outer, std::int32_t ratio_q16, const Centre& known,
                 Found& out) noexcept {
  const std::int64_t band_q16 = kOne_q16 - (square(ratio_q16) >> kQ16);
  const auto in_steps_q16 = [band_q16](std::int64_t q24) { return (q24 << 24) / (band_q16 * kStep_q16); };
  const Shift o{in_steps_q16(known.hole_q24.a), in_steps_q16(known.hole_q24.b)};
  const Equations equations(points);
  Shift c;
  if (!equations.solve(o, c)) return false;
  const std::int64_t by_hole_q16 =
      ((equations.V.aa + equations.V.bb) << kQ16) / (equations.W.aa + equations.W.bb) * kOne_q16 / band_q16;
  constexpr std::int64_t kMost_q40 = std::int64_t{1} << 36;  // a quarter of a radius
  const std::int64_t of_hole_q40 = std::min(known.hole_variance_q40, kMost_q40) / 2;
  const std::int64_t by_noise_q40 = variance_q40(equations, rest_q10(points, c, o), Ring(outer), outer.ellipse);
  out = {{c.a * kStep_q16 >> 8, c.b * kStep_q16 >> 8},
         std::min(by_noise_q40 + (of_hole_q40 * (square(by_hole_q16) >> kQ16) >> kQ16), kMost_q40)};
  return true;
}

}  // namespace

void weigh_symmetry(const ImageView& image, const EdgeFit& outer, std::int32_t ratio_q16, int& budget,
                    Centre& io) noexcept {
  const Ring seen(outer);
  if (io.uneven_q16 >= kOne_q16 || (outer.flaws & kOccluded) != 0 || !seen.is_sampled_finely() ||
      !seen.has_its_hole_in_the_middle(io.hole_q24))
    return;
  Ellipse ring = outer.ellipse;
  ring.u_q16 = io.u_q16, ring.v_q16 = io.v_q16;
  const int rays = rays_around(mean_radius_q16(ring));
  const OppositePoints points(image, ring, rays);
  budget -= kStepWindows * (kRaysPerPass + rays) * kLooksPerRay;
  Found found;
  if (!find_centre(points, outer, ratio_q16, io, found)) return;
  const std::int64_t found_q24 = in_px_q24(ring, found.variance_q40);
  if (found_q24 > 2 * std::int64_t{io.variance_q24}) return;
  const auto [a, b] = found.centre_q24;
  const std::int64_t du_q16 = ring.m00_q16 * a >> 24, dv_q16 = (ring.m10_q16 * a + ring.m11_q16 * b) >> 24;
  const std::int64_t even_q16 = kOne_q16 - io.uneven_q16, unsure_q16 = even_q16 * io.uneven_q16 >> kQ16;
  const std::int64_t apart2_q24 = (square(du_q16) + square(dv_q16)) >> 9;  // of one coordinate
  io.u_q16 += static_cast<std::int32_t>(du_q16 * even_q16 >> kQ16);
  io.v_q16 += static_cast<std::int32_t>(dv_q16 * even_q16 >> kQ16);
  io.variance_q24 = to_variance_q24(
      ((found_q24 * even_q16 + std::int64_t{io.variance_q24} * io.uneven_q16 + apart2_q24 * unsure_q16) >> kQ16));
}

}  // namespace articam::vision
