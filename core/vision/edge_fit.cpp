#include "core/vision/edge_fit.hpp"

#include <algorithm>
#include <cmath>

#include "core/vision/edge_profile.hpp"
#include "core/vision/ellipse_shape.hpp"
#include "core/vision/fixed_point.hpp"
#include "core/vision/ray_offsets.hpp"

namespace articam::vision {
namespace {

// A window that ends on the edge's flanks shows it narrower than it is, and its curvature moves it inwards by more than
// its width tells: from w = 0.085 h^2 on as if it were 1 + 15 (w / h^2 - 0.085) as wide, three times at most. Found by
// measuring rendered rings of 12 to 72 px under blurs of 0.4 to 2.5 px. In a hole, of which the window reads most, the
// two cancel; and a window that no neighbour limits is wide enough. All in squared radii, Q16.
std::int64_t whole_width_q16(std::int64_t seen_q16, std::int64_t half_window_q16, std::int64_t reach_q16) noexcept {
  if (half_window_q16 < reach_q16 || 2 * reach_q16 > kOne_q16) return seen_q16;
  constexpr std::int64_t kHarmless_q16 = 85 * kOne_q16 / 1000;
  const std::int64_t share_q16 = (seen_q16 << 2 * kQ16) / square(half_window_q16);
  const std::int64_t more_q16 = 15 * std::max<std::int64_t>(0, share_q16 - kHarmless_q16);
  return seen_q16 + (seen_q16 * std::min<std::int64_t>(more_q16, 2 * kOne_q16) >> kQ16);
}

struct Pass {
  int rays;
  std::int32_t reach_q16;
  std::int32_t half_window_q16;
  std::int64_t radius_q16;  // mean radius of the ellipse to be improved, px
  std::int64_t minor_q16;   // its semi-minor axis, where judged
  int sign;
  bool judged, plain;
};

// What the last pass has seen of the edge, in squared radii.
struct Edge {
  std::int64_t width_q16;    // its variance
  std::int64_t scatter_q40;  // of a ray about the ellipse
  std::int64_t light_q40;    // variance of what is seen of light
  std::int64_t doubted_q40;  // variance of the centre that is left by not knowing how even the light is
};

// What light does to the place of an edge, in samples.
struct Light {
  Harmonic seen_q16, believed_q16;
  std::int64_t variance_q32;  // of what is seen
  std::int64_t doubted_q32;   // what is left of the centre's when as much is believed
};

// How near a mark's neighbours are to its window, by the width of the edge, which is how far blur brings them in. Its
// border and its hole's end a tenth of a radius beyond the window's reach at least; a flat mark's nearer.
std::int64_t nearness_q16(const Pass& pass, std::int64_t flat_q16, std::int64_t width_q16) noexcept {
  const std::int64_t whole_q16 = whole_width_q16(width_q16, pass.half_window_q16, pass.reach_q16);
  const std::int64_t beyond_q16 = pass.reach_q16 + kOne_q16 / 10 - pass.half_window_q16;
  return std::min<std::int64_t>(integer_sqrt(whole_q16 << kQ16) * flat_q16 / beyond_q16, 16 * kOne_q16);
}

// The gain up to which light is not told from a mark's neighbours, nor from a border that perspective makes lopsided,
// which it does to large marks. Found by measuring rendered rings of 12 to 72 px at f = 525 px, tilted by up to 60
// degrees, under blur, in clutter and under light of 8:1.
std::int64_t least_gain_q16(std::int64_t near_q16, std::int64_t major_q16) noexcept {
  constexpr std::int64_t kNeighbours_q16 = 94 * kOne_q16 / 10000, kLopsided_q24 = 19 * kOne_q16 * 256 / 10000;
  const std::int64_t edge_q16 = std::min<std::int64_t>(near_q16, 3 * kOne_q16 / 10);
  const std::int64_t lopsided_q16 =
      std::min((major_q16 * kLopsided_q24 >> 24) * edge_q16 >> kQ16, std::int64_t{kOne_q16});
  return integer_sqrt(square(kNeighbours_q16 * near_q16 >> kQ16) + square(lopsided_q16));
}

// What the rays show of light, and the part of it that is the light's. Neighbours show in the last sample most; what it
// shows of them is taken off as many times as all samples together have it. With p the square of what is left, and v
// what noise and the least gain make of it, the odds for light are (p / v)^3. What stays unknown is the noise, where
// light is believed, and the distance of both answers, where belief is uncertain. Found by measuring, as the least
// gain.
Light believed(const RayOffsets& offsets, const Pass& pass, std::int64_t scatter_q16, std::int64_t width_q16) noexcept {
  const std::int64_t flat_q16 = std::min((pass.radius_q16 << kQ16) / pass.minor_q16, 16 * std::int64_t{kOne_q16});
  const std::int64_t near_q16 = nearness_q16(pass, flat_q16, width_q16);
  constexpr std::int64_t kMostTimes_q16 = 7 * kOne_q16 / 2;
  const std::int64_t times_q16 = std::clamp<std::int64_t>(2 * near_q16 - 6 * kOne_q16 / 10, 0, kMostTimes_q16);
  const Harmonic light{offsets.light_q16.a - (offsets.beside_q16.a * times_q16 >> kQ16),
                       offsets.light_q16.b - (offsets.beside_q16.b * times_q16 >> kQ16)};

  // Four times the last sample is as noisy as all of them.
  const std::int64_t more_q16 = kOne_q16 + (square(times_q16 / 4) >> kQ16), apart_q16 = kOne_q16 - offsets.shared_q16;
  const std::int64_t noise_q32 =
      ((scatter_q16 << 17) / offsets.rays * offsets.shared_q16 / apart_q16) * more_q16 >> kQ16;
  const std::int64_t least_q16 = least_gain_q16(near_q16, pass.radius_q16 * flat_q16 >> kQ16);
  constexpr std::int64_t kMost_q32 = std::int64_t{16} << 32;  // four samples, as rays' offsets
  // Scatter is below 24 with at least 16 rays, shared / apart below 64, more below 2; what is left of light below 18.
  static_assert((std::int64_t{24} << 33) / 16 <= std::int64_t{1} << 62 >> 16 >> 6 >> 1, "noise fits");
  static_assert((2 * square(18 * kOne_q16) >> kQ16) * (kOne_q16 / 4) * 7 < std::int64_t{1} << 62, "doubt fits");
  const std::int64_t least_q32 = std::min(square(least_q16 * offsets.per_gain_q16 >> kQ16), kMost_q32);
  const std::int64_t v_q32 = std::min(noise_q32 + least_q32, kMost_q32), p_q32 = square(light.a) + square(light.b);
  const std::int64_t belief_q16 = belief_in_light_q16(p_q32, v_q32);
  const std::int64_t unsure_q16 = belief_q16 * (kOne_q16 - belief_q16) >> kQ16;
  return {light,
          {light.a * belief_q16 >> kQ16, light.b * belief_q16 >> kQ16},
          std::min(noise_q32, kMost_q32) * 11 / 10 + least_q32 * 6 / 100,
          (std::min(noise_q32, kMost_q32) >> kQ16) * belief_q16 + (p_q32 >> kQ16) * unsure_q16 * 7 / 3};
}

// What only judged passes tell: light, and how far the edge is an ellipse. Returns the part of the shift that is
// light's.
Harmonic judge(const Pass& pass, const RayOffsets& offsets, const Harmonic& shape, std::int64_t step_q16, EdgeFit& fit,
               Edge& edge) noexcept {
  const auto radii = [step_q16](std::int64_t in_samples) { return in_samples * step_q16 >> kQ16; };
  const auto square_radii_q40 = [step_q16](std::int64_t q16) { return q16 * step_q16 * step_q16 >> 8; };
  const std::int64_t scatter_q16 = offsets.scatter_q16(offsets.seen_q16, shape);
  const Light light = pass.plain ? Light{} : believed(offsets, pass, scatter_q16, edge.width_q16);
  edge.scatter_q40 = square_radii_q40(scatter_q16);
  edge.light_q40 = square_radii_q40(light.variance_q32 >> 16);
  edge.doubted_q40 = square_radii_q40(light.doubted_q32 >> 16);
  fit.light_q24 = {light.seen_q16.a * step_q16 >> 8, light.seen_q16.b * step_q16 >> 8};
  fit.roughness_q16 = static_cast<std::int32_t>(radii(integer_sqrt(scatter_q16 << kQ16)));
  const Harmonic third = offsets.harmonic_q16(3), fourth = offsets.harmonic_q16(4);
  fit.corners_q16 = static_cast<std::int32_t>(
      radii(integer_sqrt(square(third.a) + square(third.b) + square(fourth.a) + square(fourth.b))));
  return light.believed_q16;
}

// An edge that is s samples off smears the profile over all rays by s^2 / 2, so that the filter sees it farther off.
// With V the variance of what is seen of the profile, s = seen / sqrt(1 + seen^2 / (3 V)).
Harmonic unsmeared(const Harmonic& seen_q16, std::int64_t variance_q16) noexcept {
  const std::int64_t power_q16 = (square(seen_q16.a) + square(seen_q16.b)) >> kQ16;
  const std::int64_t more_q16 = kOne_q16 + (power_q16 << kQ16) / (3 * variance_q16 + kOne_q16);
  const std::int64_t root_q16 = integer_sqrt(more_q16 << kQ16);
  return {(seen_q16.a << kQ16) / root_q16, (seen_q16.b << kQ16) / root_q16};
}

// One step: reads the rays, moves the ellipse. False where there is no edge all round.
bool improve(const ImageView& image, const Pass& pass, EdgeFit& fit, Edge& edge) noexcept {
  RaySamples samples;
  EdgeProfile profile;
  read_rays(image, fit.ellipse, pass.half_window_q16, pass.rays, samples);
  if (!find_profile(samples, pass.sign, profile)) return false;
  PerRay crosses;
  const int weak = find_crossings(samples, pass.sign, profile, crosses);
  if (8 * weak > pass.rays) return false;  // the edge goes all round, but for an eighth
  fit.contrast_q4 = profile.contrast_q4;
  fit.flaws = static_cast<std::uint8_t>((profile.saturated ? kSaturated : 0) | (profile.clipped ? kClipped : 0) |
                                        (weak > 0 ? kOccluded : 0));

  const std::int64_t step_q16 = 2 * pass.half_window_q16 / (kSamples - 1);
  const auto radii = [step_q16](std::int64_t in_samples) { return in_samples * step_q16 >> kQ16; };
  RayOffsets offsets;
  find_offsets(samples, profile, crosses, offsets);
  if (pass.judged && !pass.plain)
    take_off_blending(samples, profile, crosses, fit.ellipse, pass.minor_q16, pass.half_window_q16, offsets);
  const Harmonic shape = offsets.harmonic_q16(2);
  const Harmonic seen = pass.judged ? offsets.seen_q16 : unsmeared(offsets.seen_q16, profile.variance_q16);
  edge.width_q16 = radii(radii(profile.variance_q16));
  Harmonic by_light;
  if (pass.judged) {
    if (!pass.plain) find_light(samples, profile, pass.half_window_q16, offsets);
    by_light = judge(pass, offsets, shape, step_q16, fit, edge);
  }

  Ellipse& e = fit.ellipse;
  const auto moved_u = [&](std::int64_t a) { return static_cast<std::int32_t>(e.u_q16 + (e.m00_q16 * a >> kQ16)); };
  const auto moved_v = [&](std::int64_t a, std::int64_t b) {
    return static_cast<std::int32_t>(e.v_q16 + ((e.m10_q16 * a + e.m11_q16 * b) >> kQ16));
  };
  const std::int64_t a = radii(seen.a + by_light.a), b = radii(seen.b + by_light.b);
  fit.plain_u_q16 = moved_u(radii(seen.a)), fit.plain_v_q16 = moved_v(radii(seen.a), radii(seen.b));
  e.u_q16 = moved_u(a), e.v_q16 = moved_v(a, b);
  const std::int64_t size = radii(profile.position_q16);
  return deform(e, size + radii(shape.a), radii(shape.b), size - radii(shape.a));
}

// Rays that read the same pixels know less than as many independent ones: how many times their scatter's share the
// centre's variance is, by the distance of neighbours along the edge; less where the edge is sharp. Measured, 12 to
// 72 px, blur 0.7 to 2 px.
std::int64_t dependence_q16(std::int64_t mean_square_q16, int rays, std::int64_t width_px_q16) noexcept {
  constexpr std::int64_t kTurn_q16 = 411775, kApart_q16 = 31 * kOne_q16 / 20, kFar_q16 = 21 * kOne_q16 / 20;
  constexpr std::int64_t kPixel_q16 = 7 * kOne_q16 / 5;  // rays nearer than this see the same
  const std::int64_t pitch_q16 = integer_sqrt(mean_square_q16 << kQ16) * kTurn_q16 / rays >> kQ16;
  const std::int64_t by_blur_q16 = kFar_q16 + std::clamp<std::int64_t>(kApart_q16 - pitch_q16, 0, width_px_q16 / 3);
  return std::max(by_blur_q16, (kPixel_q16 << kQ16) / std::max<std::int64_t>(pitch_q16, 1));
}

// centre = M c, and each of c's variances is 2 / rays of the scatter; the mean of those of u and v. A semi-axis is
// M (1 + s + p): three halves of it, and a third of what undo_blur() adds, which the window's narrowness limits.
void put_variances(const Edge& edge, const Pass& pass, EdgeFit& fit) noexcept {
  constexpr std::int64_t kCutOff_q24 = (1 << 24) / 2500;  // 0.02 px: what moves an edge whose end is cut off
  const std::int64_t square_q16 = mean_square_q16(fit.ellipse);
  const std::int64_t blur_q16 = integer_sqrt(edge.width_q16 << kQ16) * pass.radius_q16 >> kQ16;
  const std::int64_t shared_q16 = dependence_q16(square_q16, pass.rays, blur_q16) * 2 / pass.rays;
  fit.plain_variance_q40 = edge.scatter_q40 * shared_q16 >> kQ16;
  if ((fit.flaws & (kSaturated | kClipped)) != 0) fit.plain_variance_q40 += (kCutOff_q24 << 32) / square_q16;
  fit.light_variance_q40 = edge.light_q40;
  const std::int64_t centre_q24 = in_px_q24(fit.ellipse, fit.plain_variance_q40 + edge.doubted_q40) + kGrid_q24;
  fit.centre_variance_q24 = to_variance_q24(centre_q24);
  const std::int64_t bias_q16 = edge.width_q16 / 6;  // radii
  const std::int64_t bias_q24 = (square_q16 * bias_q16 >> kQ16) * bias_q16 >> 8;
  fit.axis_variance_q24 = to_variance_q24(centre_q24 * 3 / 2 + bias_q24);
  fit.blur_q8 = static_cast<std::uint16_t>(std::min<std::int64_t>(blur_q16 >> 8, 0xffff));
  if (fit.blur_q8 > kSharp_q8) fit.flaws |= kBlurred;
}

// A fit that wandered off has found some other edge.
bool is_near(const Ellipse& e, std::int64_t radius_q16, const Ellipse& seed, std::int64_t seed_radius_q16) noexcept {
  const auto similar = [](std::int64_t a, std::int64_t b) { return 10 * a > 7 * b && 10 * a < 13 * b; };
  const std::int64_t du = e.u_q16 - seed.u_q16, dv = e.v_q16 - seed.v_q16;
  return 4 * (du * du + dv * dv) < square(seed_radius_q16) && similar(radius_q16, seed_radius_q16);
}

// The largest change of the centre or of M, px, Q16.
std::int32_t change_q16(const Ellipse& a, const Ellipse& b) noexcept {
  return std::max({std::abs(a.u_q16 - b.u_q16), std::abs(a.v_q16 - b.v_q16), std::abs(a.m00_q16 - b.m00_q16),
                   std::abs(a.m10_q16 - b.m10_q16), std::abs(a.m11_q16 - b.m11_q16)});
}

// Half of the window across an edge of that width, radii, Q16.
std::int64_t half_window_q16(std::int64_t width_q16, std::int64_t radius_q16) noexcept {
  constexpr std::int64_t kWidths_q16 = 17 * kOne_q16 / 5, kSharp_q16 = 13 * kOne_q16 / 5, kBlurred_q16 = 6 * kOne_q16;
  const std::int64_t follow_q16 = integer_sqrt(width_q16 << kQ16) * kWidths_q16 >> kQ16;
  return (std::clamp(follow_q16 * radius_q16 >> kQ16, kSharp_q16, kBlurred_q16) << kQ16) / radius_q16;
}

}  // namespace

std::int64_t belief_in_light_q16(std::int64_t p, std::int64_t v) noexcept {
  constexpr std::int64_t kMost_q8 = 16 << 8;
  static_assert(kMost_q8 * kMost_q8 * kMost_q8 < std::int64_t{1} << 40);
  const std::int64_t against_q8 = std::min((v << 8) / std::max<std::int64_t>(p, 1), kMost_q8);
  return (std::int64_t{1} << (24 + kQ16)) / ((1 << 24) + against_q8 * against_q8 * against_q8);
}

bool fit_edge(const ImageView& image, Inside inside, Reading reading, std::int32_t reach_q16, const Ellipse& seed,
              int& budget, EdgeFit& out) noexcept {
  // Few rays until the next pass moves the ellipse by less than their noise allows to see, then all of them.
  constexpr int kCoarseRays = 16, kCoarsePasses = 3, kFinePasses = 3;
  constexpr std::int32_t kCoarseStill_q16 = kOne_q16 / 2, kStill_q16 = kOne_q16 / 14;
  constexpr std::int64_t kOfSeed_q16 = 9 * kOne_q16 / 2;  // half of the first window, px
  const int sign = inside == Inside::darker ? 1 : -1;
  EdgeFit fit{.ellipse = seed};
  Edge edge{};
  const std::int64_t seed_radius_q16 = mean_radius_q16(seed);
  if (seed_radius_q16 < kOne_q16) return false;
  Pass pass{kCoarseRays, reach_q16, 0, seed_radius_q16, 0, sign, false, reading == Reading::plain};
  for (int i_pass = 0, left = kCoarsePasses; left > 0; ++i_pass) {
    const Ellipse before = fit.ellipse;
    if (pass.judged) pass.rays = rays_around(pass.radius_q16), pass.minor_q16 = minor_q16(fit.ellipse);
    const std::int64_t wanted_q16 =
        i_pass == 0 ? (kOfSeed_q16 << kQ16) / pass.radius_q16 : half_window_q16(edge.width_q16, pass.radius_q16);
    pass.half_window_q16 = static_cast<std::int32_t>(std::min<std::int64_t>(reach_q16, wanted_q16));
    budget -= (kRaysPerPass + pass.rays) * kLooksPerRay;
    if (!improve(image, pass, fit, edge)) return false;
    pass.radius_q16 = mean_radius_q16(fit.ellipse);
    if (!is_near(fit.ellipse, pass.radius_q16, seed, seed_radius_q16)) return false;
    const bool still = change_q16(fit.ellipse, before) < (pass.judged ? kStill_q16 : kCoarseStill_q16);
    --left;
    if (pass.judged && still) break;
    if (!pass.judged && (still || left == 0)) pass.judged = true, left = kFinePasses;
  }
  edge.width_q16 = whole_width_q16(edge.width_q16, pass.half_window_q16, reach_q16);
  put_variances(edge, pass, fit);
  if (!undo_blur(fit.ellipse, edge.width_q16)) return false;
  out = fit;
  return true;
}

}  // namespace articam::vision
