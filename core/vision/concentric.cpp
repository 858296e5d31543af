#include "core/vision/concentric.hpp"

#include <algorithm>

#include "core/vision/ellipse_shape.hpp"
#include "core/vision/fixed_point.hpp"

namespace articam::vision {
namespace {

// Here lengths are radii of the outer edge, Q24, and variances their squares, Q40.
constexpr int kQ24 = 24;
constexpr std::int64_t kOne_q24 = 1 << kQ24;
constexpr std::int64_t kLeast_q40 = 16, kMost_q40 = std::int64_t{1} << 36;  // a quarter of a radius

constexpr std::int64_t square_q40(std::int64_t x_q24) noexcept { return (x_q24 * x_q24) >> 8; }

constexpr std::int64_t share_q16(std::int64_t part, std::int64_t whole) noexcept { return (part << kQ16) / whole; }

// px -> radii along the columns of M.
Shift in_radii(const Ellipse& e, std::int64_t u_q16, std::int64_t v_q16) noexcept {
  const std::int64_t a = (u_q16 << kQ24) / e.m00_q16;
  return {a, ((v_q16 << kQ24) - e.m10_q16 * a) / e.m11_q16};
}

// In the direction in which the two offsets differ, and across.
struct Turn {
  std::int64_t cos_q24, sin_q24;
  Shift operator()(const Shift& s) const noexcept {
    return {(s.a * cos_q24 + s.b * sin_q24) >> kQ24, (s.b * cos_q24 - s.a * sin_q24) >> kQ24};
  }
  Shift back(const Shift& s) const noexcept {
    return {(s.a * cos_q24 - s.b * sin_q24) >> kQ24, (s.a * sin_q24 + s.b * cos_q24) >> kQ24};
  }
};

// Variances of what is seen.
struct Noise {
  std::int64_t outer, hole, light, offset;
  std::int32_t ratio_q16;
};

// tanh of z, to 0.024; 1 from 3 on.
std::int64_t tanh_q16(std::int64_t z_q16) noexcept {
  const std::int64_t z = std::clamp<std::int64_t>(z_q16, -3 * kOne_q16, 3 * kOne_q16), z2 = z * z >> kQ16;
  return z * (27 * kOne_q16 + z2) / (27 * kOne_q16 + 9 * z2);
}

// The offset's part that has a sign, and what is not known of it: d less it has the variance `of_seen_q40`.
struct Sided {
  std::int64_t offset_q24, variance_q40;
};

Sided likely_side(std::int64_t seen_q24, std::int64_t half_q24, std::int64_t of_seen_q40) noexcept {
  const std::int64_t most = std::int64_t{1} << 45;
  const std::int64_t product = std::clamp((seen_q24 * half_q24) >> 8, -most, most);
  const std::int64_t t_q16 = tanh_q16(share_q16(product, of_seen_q40));
  return {half_q24 * t_q16 >> kQ16, square_q40(half_q24) * (kOne_q16 - (t_q16 * t_q16 >> kQ16)) >> kQ16};
}

struct Estimate {
  std::int64_t place_q24, variance_q40;
  std::int64_t contradicts_q40;  // squared, where it does
  Sided side;
};

// c from  0 = c, d = c + o.
Estimate in_even_light(std::int64_t seen_q24, std::int64_t half_q24, const Noise& noise) noexcept {
  const Sided side = likely_side(seen_q24, half_q24, noise.outer + noise.hole + noise.offset);
  const std::int64_t of_hole = noise.hole + noise.offset + side.variance_q40;
  const std::int64_t weight_q16 = share_q16(noise.outer, noise.outer + of_hole);
  return {(seen_q24 - side.offset_q24) * weight_q16 >> kQ16, noise.outer * (kOne_q16 - weight_q16) >> kQ16, 0, side};
}

// c and x from  0 = c - x, d = c + o + k x, l = x, in weights by the first's.
Estimate in_any_light(std::int64_t seen_q24, std::int64_t half_q24, std::int64_t light_q24,
                      const Noise& noise) noexcept {
  const std::int64_t k = noise.ratio_q16, more = kOne_q16 + k;
  const std::int64_t beside_q24 = seen_q24 - (more * light_q24 >> kQ16);  // what light does not explain
  const std::int64_t of_beside =
      noise.outer + noise.hole + noise.offset + ((more * more >> kQ16) * noise.light >> kQ16);
  const Sided side = likely_side(beside_q24, half_q24, of_beside);
  const std::int64_t left_q24 = beside_q24 - side.offset_q24;
  constexpr std::int64_t kMost_q16 = 64 * kOne_q16;
  const std::int64_t h = share_q16(noise.outer, noise.hole + noise.offset + side.variance_q40);
  const std::int64_t l = std::min(share_q16(noise.outer, noise.light), kMost_q16);
  // | 1 + h     -1 + k h       | |c|   | h y       |
  // | -1 + k h   1 + k^2 h + l | |x| = | k h y + l l |
  const std::int64_t kh = k * h >> kQ16, A = kOne_q16 + h, B = kh - kOne_q16, C = kOne_q16 + (k * kh >> kQ16) + l;
  const std::int64_t y_q24 = seen_q24 - side.offset_q24;
  const std::int64_t r0_q24 = h * y_q24 >> kQ16, r1_q24 = (kh * y_q24 + l * light_q24) >> kQ16;
  const std::int64_t det_q16 = (A * C - B * B) >> kQ16;
  return {(C * r0_q24 - B * r1_q24) / det_q16, (noise.outer * share_q16(C, det_q16)) >> kQ16,
          square_q40(left_q24) > 16 * (of_beside + side.variance_q40) ? square_q40(left_q24) : 0, side};
}

// The offset's half is the root of a square that is known by how the ring's axes differ: near 0 its direction is not
// known. What blur may have left of the axes differs as their squares do.
std::int64_t of_offset_q40(const EdgeFit& outer, std::int64_t of_outer_q40, const HoleOffset& offset,
                           const Pinhole& camera, std::int64_t half_q24) noexcept {
  const std::int64_t major2_q16 = major_square_q16(outer.ellipse);
  const std::int64_t differ_q16 = kOne_q16 - share_q16(2 * mean_square_q16(outer.ellipse) - major2_q16, major2_q16);
  const std::int64_t of_axes_q40 =
      std::min((2 * std::int64_t{outer.axis_variance_q24} << 28) / (major2_q16 >> 4), kMost_q40);
  const std::int64_t of_share_q40 = 4 * of_outer_q40 + (of_axes_q40 * (square(differ_q16) >> kQ16) >> kQ16);
  const std::int64_t scale_q24 = (std::int64_t{offset.scale_q16} << kQ24) / offset.major_q16;
  const std::int64_t scale_q40 = std::min(square_q40(scale_q24), std::int64_t{1} << 38);
  const std::int64_t of_square = std::min(scale_q40 * integer_sqrt(of_share_q40 << 8) >> kQ24, std::int64_t{1} << 31);
  return of_square * of_square / (square_q40(half_q24) + 2 * of_square + 1) +
         square_q40(scale_q24 * camera.unsure_q16 >> kQ16);
}

Noise noise_of(const EdgeFit& outer, const EdgeFit& hole, std::int32_t ratio_q16) noexcept {
  const std::int64_t grid = (kGrid_q24 << 32) / std::max<std::int64_t>(mean_square_q16(outer.ellipse), 1);
  const auto bounded = [](std::int64_t v_q40) { return std::clamp(v_q40, kLeast_q40, kMost_q40); };
  const std::int64_t of_outer = bounded(outer.plain_variance_q40 + grid);
  // The hole's few rays scatter by less than they err.
  const std::int64_t fainter_q16 =
      std::max<std::int64_t>(share_q16(outer.contrast_q4, std::max<std::int32_t>(hole.contrast_q4, 1)), kOne_q16);
  const std::int64_t by_size = (share_q16(of_outer, ratio_q16) * (square(fainter_q16) >> kQ16)) >> kQ16;
  const std::int64_t by_scatter = hole.plain_variance_q40 * (square(ratio_q16) >> kQ16) >> kQ16;
  return {of_outer, bounded(std::max(by_size, by_scatter) + grid), bounded(outer.light_variance_q40 + grid), 0,
          ratio_q16};
}

// What both edges see, turned into the direction in which the two offsets differ.
struct Sight {
  Turn turn;
  Shift hole, light;
  std::int64_t half_q24;
};

Sight sight_of(const EdgeFit& outer, const EdgeFit& hole, const HoleOffset& offset) noexcept {
  const Shift half = in_radii(outer.ellipse, offset.half_u_q16, offset.half_v_q16);
  const Shift seen = in_radii(outer.ellipse, hole.plain_u_q16 - outer.plain_u_q16 - offset.mean_u_q16,
                              hole.plain_v_q16 - outer.plain_v_q16 - offset.mean_v_q16);
  const std::int64_t half_q24 = integer_sqrt(square(half.a) + square(half.b));
  const Turn turn = half_q24 > 0 ? Turn{(half.a << kQ24) / half_q24, (half.b << kQ24) / half_q24} : Turn{kOne_q24, 0};
  return {turn, turn(seen), turn(outer.light_q24), half_q24};
}

// One coordinate: where light is uneven, where it is even, and the mean of both by how likely they are.
Estimate weighed(const Estimate& any, const Estimate& even, std::int64_t belief_q16) noexcept {
  const auto mixed = [belief_q16](std::int64_t e, std::int64_t a) { return e + ((a - e) * belief_q16 >> kQ16); };
  const std::int64_t apart_q24 = any.place_q24 - even.place_q24;
  const std::int64_t unsure_q16 = belief_q16 * (kOne_q16 - belief_q16) >> kQ16;
  return {mixed(even.place_q24, any.place_q24),
          mixed(even.variance_q40, any.variance_q40) + (square_q40(apart_q24) * unsure_q16 >> kQ16),
          any.contradicts_q40,
          {mixed(even.side.offset_q24, any.side.offset_q24),
           mixed(even.side.variance_q40, any.side.variance_q40) +
               (square_q40(any.side.offset_q24 - even.side.offset_q24) * unsure_q16 >> kQ16)}};
}

}  // namespace

bool join_centres(const EdgeFit& outer, const EdgeFit& hole, const Pinhole& camera, std::int32_t ratio_q16,
                  Centre& out) noexcept {
  const Ellipse& e = outer.ellipse;
  out = {e.u_q16, e.v_q16, outer.centre_variance_q24};
  HoleOffset offset;
  if (!hole_offset(e, camera, ratio_q16, offset)) return true;
  const auto [turn, d, l, half_q24] = sight_of(outer, hole, offset);
  Noise noise = noise_of(outer, hole, ratio_q16);
  noise.offset = of_offset_q40(outer, noise.outer, offset, camera, half_q24);

  // Found by measuring rendered rings of 12 to 72 px, in even light and in light of 8:1: light is believed in from
  // twice its variance on, and errors are a little below what this model says.
  const std::int64_t belief_q16 = belief_in_light_q16(square_q40(l.a) + square_q40(l.b), 2 * noise.light);
  const Estimate a = weighed(in_any_light(d.a, half_q24, l.a, noise), in_even_light(d.a, half_q24, noise), belief_q16);
  const Estimate b = weighed(in_any_light(d.b, 0, l.b, noise), in_even_light(d.b, 0, noise), belief_q16);
  if (const std::int64_t by_q40 = a.contradicts_q40 + b.contradicts_q40; by_q40 > 0) {
    constexpr std::int64_t kTenth_q40 = (std::int64_t{1} << 40) / 100;
    out.variance_q24 = to_variance_q24(outer.centre_variance_q24 + in_px_q24(e, by_q40 / 2));
    return by_q40 < kTenth_q40;
  }
  const Shift c = turn.back({a.place_q24, b.place_q24}), sided = turn.back({a.side.offset_q24, 0});
  const Shift mean = in_radii(e, offset.mean_u_q16, offset.mean_v_q16);
  out = {outer.plain_u_q16 + static_cast<std::int32_t>(e.m00_q16 * c.a >> kQ24),
         outer.plain_v_q16 + static_cast<std::int32_t>((e.m10_q16 * c.a + e.m11_q16 * c.b) >> kQ24),
         to_variance_q24(in_px_q24(e, (a.variance_q40 + b.variance_q40) * 12 / 25)),
         true,
         belief_q16,
         {mean.a + sided.a, mean.b + sided.b},
         2 * noise.offset + a.side.variance_q40};
  return true;
}

}  // namespace articam::vision
