#include "core/vision/symmetric_fit.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/vision/fixed_point.hpp"

namespace articam::vision {
namespace {

// y = D / 2 + (a, b) . (1 - r^2) o, in which c is sought. Slopes are Q3, D / 2 Q5, steps Q16.
struct Seen {
  Shift u_q16;  // (1 - r^2) o
  Seen(const Shift& o, std::int64_t inside_q16) noexcept : u_q16{o.a * inside_q16 >> kQ16, o.b * inside_q16 >> kQ16} {}
  // f . y, Q22, for f . D and f . (a, b).
  std::int64_t times_q22(std::int64_t fD, std::int64_t fa, std::int64_t fb) const noexcept {
    return (fD << 14) + fa * u_q16.a + fb * u_q16.b;
  }
  std::int64_t square_q10(const OppositeSums& s, std::size_t j) const noexcept {
    const std::int64_t linear_q24 = 2 * (u_q16.a * s.aD[j] + u_q16.b * s.bD[j]);
    const std::int64_t square_q22 = (u_q16.a * u_q16.a >> kQ16) * s.aa[j] + 2 * (u_q16.a * u_q16.b >> kQ16) * s.ab[j] +
                                    (u_q16.b * u_q16.b >> kQ16) * s.bb[j];
    return s.DD[j] + (linear_q24 >> 14) + (square_q22 >> 12);
  }
};

int shift_to_20_bits(std::int64_t x) noexcept {
  return std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(x))) - 20);
}

Shift shifted(const Shift& x, int down) noexcept { return {x.a >> down, x.b >> down}; }

// How much less is left of squares when x is what its equations, with that right side, say.
std::int64_t explained_q10(const Shift& x_q16, const Shift& right, int down) noexcept {
  return ((x_q16.a * (right.a >> 12) + x_q16.b * (right.b >> 12)) >> 16) << down;
}

Symmetric2 shifted(const Symmetric2& m, int down) noexcept { return {m.aa >> down, m.ab >> down, m.bb >> down}; }

// Adds the equations of the centre.
void add(const OppositePoints& points, int last, const Shift& o, SymmetricFit& out) noexcept {
  points.for_each(last, [&](const OppositeSums& s, std::size_t j, std::int64_t i, std::int64_t inside_q16) {
    const Seen y(o, inside_q16);
    out.W.aa += i * s.aa[j], out.W.ab += i * s.ab[j], out.W.bb += i * s.bb[j];
    out.right.a -= i * y.times_q22(s.aD[j], s.aa[j], s.ab[j]);
    out.right.b -= i * y.times_q22(s.bD[j], s.ab[j], s.bb[j]);
    out.left_q10 += i * y.square_q10(s, j);
    out.area += static_cast<int>(i);
  });
}

// Light that grows by so much in 32 steps adds g = (x, y) i / 32 of it to D / 2.
struct Light {
  Symmetric2 G;
  Shift right;                  // g . y
  std::int64_t ax, ay, bx, by;  // slopes by g
};
Light light_of(const OppositePoints& points, const Shift& o) noexcept {
  Light light{};
  points.for_each(kStepsWithBorder, [&](const OppositeSums& s, std::size_t j, std::int64_t i, std::int64_t inside_q16) {
    const Seen y(o, inside_q16);
    const std::int64_t i2 = i * i, i3 = i * i2;
    light.G.aa += i3 * s.xx[j] >> 10, light.G.ab += i3 * s.xy[j] >> 10, light.G.bb += i3 * s.yy[j] >> 10;
    light.ax += i2 * s.ax[j] >> 5, light.ay += i2 * s.ay[j] >> 5;
    light.bx += i2 * s.bx[j] >> 5, light.by += i2 * s.by[j] >> 5;
    light.right.a += i2 * y.times_q22(s.xD[j], s.ax[j], s.bx[j]) >> 5;
    light.right.b += i2 * y.times_q22(s.yD[j], s.ay[j], s.by[j]) >> 5;
  });
  return light;
}

}  // namespace

bool SymmetricFit::solve(Shift& c_q16, std::int64_t& rest_q10) const noexcept {
  constexpr std::int64_t kMost = std::int64_t{1} << 38;  // four steps of the largest W; products with W fit
  if (!W.is_round() || std::abs(right.a) >= kMost || std::abs(right.b) >= kMost) return false;
  const Shift c = W.adjugate_times(right);
  c_q16 = {c.a / W.det(), c.b / W.det()};
  rest_q10 = std::max<std::int64_t>(left_q10 - explained_q10(c_q16, right, down), 1);
  return square(c_q16.a) + square(c_q16.b) <= square(kOne_q16);
}

SymmetricFit fit_in_even_light(const OppositePoints& points, const Shift& o) noexcept {
  SymmetricFit fit;
  add(points, kStepsInRing, o, fit);
  fit.down = shift_to_20_bits(fit.W.trace());
  fit.W = shifted(fit.W, fit.down), fit.right = shifted(fit.right, fit.down);
  return fit;
}

// With X the products of slopes and g:  | W -X; -X^T G | (c, light) = (right, g . y); light is eliminated.
bool fit_in_any_light(const OppositePoints& points, const Shift& o, SymmetricFit& out) noexcept {
  SymmetricFit fit;
  add(points, kStepsWithBorder, o, fit);
  const Light light = light_of(points, o);
  // The unit of light is such that G, too, has 20 bits.
  fit.down = shift_to_20_bits(fit.W.trace());
  const int of_light = shift_to_20_bits(light.G.trace()), mean = (fit.down + of_light + 1) / 2;
  const Symmetric2 w = shifted(fit.W, fit.down), g = shifted(light.G, 2 * mean - fit.down);
  const Shift xa = shifted(Shift{light.ax, light.ay}, mean), xb = shifted(Shift{light.bx, light.by}, mean);
  const Shift right = shifted(fit.right, fit.down), seen = shifted(light.right, mean);
  constexpr std::int64_t kMost_q20 = std::int64_t{1} << 24, kMostSeen = std::int64_t{1} << 37;
  if (!g.is_round() || std::abs(seen.a) >= kMostSeen || std::abs(seen.b) >= kMostSeen) return false;
  // Y = X G^-1, Q20, by rows.
  const auto over_g_q20 = [&g](const Shift& x) {
    const Shift y = g.adjugate_times(x);
    return Shift{(y.a << 20) / g.det(), (y.b << 20) / g.det()};
  };
  const Shift ya = over_g_q20(xa), yb = over_g_q20(xb);
  for (const std::int64_t y : {ya.a, ya.b, yb.a, yb.b})
    if (std::abs(y) >= kMost_q20) return false;
  const auto times = [](const Shift& y_q20, const Shift& x) { return (y_q20.a * x.a + y_q20.b * x.b) >> 20; };
  fit.W = {w.aa - times(ya, xa), w.ab - times(ya, xb), w.bb - times(yb, xb)};
  fit.right = {right.a + times(ya, seen), right.b + times(yb, seen)};
  const Shift gain = g.adjugate_times(seen);
  fit.left_q10 -= explained_q10({gain.a / g.det(), gain.b / g.det()}, seen, fit.down);
  out = fit;
  return true;
}

std::int64_t share_of_offset_q16(const OppositePoints& points) noexcept {
  std::int64_t whole = 0, part_q16 = 0;
  points.for_each(kStepsInRing, [&](const OppositeSums& s, std::size_t j, std::int64_t i, std::int64_t inside_q16) {
    const std::int64_t slopes = i * (std::int64_t{s.aa[j]} + s.bb[j]);
    whole += slopes, part_q16 += slopes * inside_q16;
  });
  return part_q16 / std::max<std::int64_t>(whole, 1);
}

}  // namespace articam::vision
