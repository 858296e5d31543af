#include "host_sim/world/clutter.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.hpp"
#include "host_sim/world/hash.hpp"

namespace articam::sim {
namespace {

/// Blends `grey` where the signed distance (px, negative inside) says so, in a box around a centre.
template <class Distance>
void paint(GreyPlane& plane, double u, double v, double reach, double grey, const Distance& distance) {
  const int u_min = std::max(0, static_cast<int>(u - reach) - 1);
  const int v_min = std::max(0, static_cast<int>(v - reach) - 1);
  const int u_max = std::min(plane.width_px - 1, static_cast<int>(u + reach) + 1);
  const int v_max = std::min(plane.height_px - 1, static_cast<int>(v + reach) + 1);
  for (int y = v_min; y <= v_max; ++y) {
    std::int16_t* row = plane.row(y);
    for (int x = u_min; x <= u_max; ++x) {
      const double cover = std::clamp(0.5 - distance(x - u, y - v), 0.0, 1.0);
      const double under = row[x];
      row[x] = static_cast<std::int16_t>(under + cover * (grey_q6(grey) - under));
    }
  }
}

struct Bar {
  double u, v, half_length, half_width, angle_rad, grey;
};

void paint_bar(GreyPlane& plane, const Bar& bar) {
  const auto turn = math::sin_cos(bar.angle_rad);
  paint(plane, bar.u, bar.v, bar.half_length + bar.half_width, bar.grey, [&](double x, double y) {
    const double along = std::abs(turn.cos * x + turn.sin * y) - bar.half_length;
    const double across = std::abs(turn.cos * y - turn.sin * x) - bar.half_width;
    return std::max(along, across);
  });
}

/// Flattened along v; a disc where inner_ratio is 0.
struct Annulus {
  double u, v, radius, inner_ratio, flat, grey;
};

void paint_annulus(GreyPlane& plane, const Annulus& ring) {
  paint(plane, ring.u, ring.v, ring.radius, ring.grey, [&](double x, double y) {
    const double r = std::sqrt(x * x + y * y / (ring.flat * ring.flat));
    return std::max(r - ring.radius, ring.inner_ratio * ring.radius - r);
  });
}

/// Lines of words: short dark bars with gaps, on a light sheet that is a little turned.
void paint_sheet(GreyPlane& plane, Dice& dice) {
  const double u = dice.between(0, plane.width_px), v = dice.between(0, plane.height_px);
  const double half_length = dice.between(40, 90), half_width = dice.between(30, 70);
  const double angle_rad = dice.between(-0.3, 0.3);
  const auto turn = math::sin_cos(angle_rad);
  paint_bar(plane, {u, v, half_length, half_width, angle_rad, dice.between(185, 225)});
  const double ink = dice.between(30, 80), pitch = dice.between(6, 11);
  for (double y = -half_width + pitch; y < half_width - 4; y += pitch) {
    for (double x = -half_length + 8; x < half_length - 8;) {
      const double word = dice.between(2, 9);
      const double middle = x + word;
      const double u_word = u + turn.cos * middle - turn.sin * y, v_word = v + turn.sin * middle + turn.cos * y;
      paint_bar(plane, {u_word, v_word, word, 0.25 * pitch, angle_rad, ink});
      x += 2 * word + dice.between(2, 5);
    }
  }
}

/// Smooth random grain: values on a lattice, blended linearly between its nodes.
void paint_texture(GreyPlane& plane, std::uint64_t seed) {
  constexpr int kCell_px = 5;
  constexpr double kAmplitude = 14;  // grey levels
  const auto node = [&](int column, int row) {
    const auto place = static_cast<std::uint64_t>(row) << 32U | static_cast<std::uint64_t>(column);
    return kAmplitude * (static_cast<double>(hash(seed ^ hash(place)) >> 11U) * 0x1p-52 - 1);
  };
  for (int v = 0; v < plane.height_px; ++v) {
    const double y = static_cast<double>(v % kCell_px) / kCell_px;
    for (int u = 0; u < plane.width_px; ++u) {
      const double x = static_cast<double>(u % kCell_px) / kCell_px;
      const int i = u / kCell_px, j = v / kCell_px;
      const double above = node(i, j) * (1 - x) + node(i + 1, j) * x;
      const double below = node(i, j + 1) * (1 - x) + node(i + 1, j + 1) * x;
      plane.row(v)[u] = static_cast<std::int16_t>(plane.row(v)[u] + grey_q6(above * (1 - y) + below * y));
    }
  }
}

}  // namespace

void paint_clutter(std::uint64_t seed, GreyPlane& plane) {
  // Braces fix the order in which the dice fall; the order of function arguments is the compiler's choice.
  Dice dice{seed};
  const double width = plane.width_px, height = plane.height_px;
  for (int i = 0; i < 12; ++i) {
    paint_bar(plane, {dice.between(0, width), dice.between(0, height), dice.between(10, 120), dice.between(2, 50),
                      dice.between(-1.6, 1.6), dice.between(50, 200)});
  }
  for (int i = 0; i < 4; ++i) paint_sheet(plane, dice);
  for (int i = 0; i < 10; ++i) {
    paint_annulus(plane, {dice.between(0, width), dice.between(0, height), dice.between(4, 22), 0, dice.between(0.5, 1),
                          i % 2 == 0 ? 40.0 : 210.0});
  }
  for (int i = 0; i < 10; ++i) {  // ratios below 0.25 and above 0.62; the rings have 0.41
    const Annulus ring{dice.between(0, width), dice.between(0, height),
                       dice.between(8, 24),    i % 2 == 0 ? dice.between(0.62, 0.85) : dice.between(0.12, 0.25),
                       dice.between(0.6, 1),   40};
    paint_annulus(plane, {ring.u, ring.v, 1.3 * ring.radius, 0, 1, 205});
    paint_annulus(plane, ring);
  }
  paint_texture(plane, hash(seed + 1));
  for (std::int16_t& grey : plane.q6) grey = static_cast<std::int16_t>(std::clamp<int>(grey, 0, kMaxGrey_q6));
}

}  // namespace articam::sim
