#pragma once
/// @file  A mark to print, and the room that it takes on paper.

#include <cmath>
#include <string>
#include <vector>

#include "core/model/model_table.hpp"

namespace articam::markers {

struct Mark {
  std::string name;  ///< the URDF link that carries it
  model::MarkerKind kind{};
  double outer_mm{};  ///< diameter; of a dot, its only one
  double inner_mm{};  ///< diameter of a ring's hole; 0 otherwise
};

/// The rows of a model, static or just compiled (MarkerRow, TableMarker), as marks. Points are not printed.
template <class Rows>
std::vector<Mark> marks_of(const Rows& rows) {
  std::vector<Mark> marks;
  for (const auto& row : rows) {
    if (row.kind == model::MarkerKind::point) continue;
    marks.push_back({std::string{row.name}, row.kind, 1000 * row.outer_diameter_m, 1000 * row.inner_diameter_m});
  }
  return marks;
}

// Around a mark, from inside to outside: its quiet zone, the ticks, the cut, the crop marks; below them its label.
inline constexpr double kTick_mm = 2;
inline constexpr double kCropZone_mm = 4;
inline constexpr double kLabel_mm = 10;
inline constexpr double kLeastWidth_mm = 45;  ///< so that the label of a small mark can be read

/// Plain ground around the edge. The detector's fit looks at most 0.21 diameters out of a ring's edge (the thinnest
/// hole) and 0.16 out of a dot's (core/vision/mark.cpp); the rest is for the blur of a small image.
inline double quiet_zone_mm(const Mark& mark) { return mark.outer_mm / 4; }

/// Side of the square to cut out, a whole number so that it can be measured. Square, because a round dark patch with a
/// light dot in it would be a ring.
inline double square_mm(const Mark& mark) {
  constexpr double kRounding = 1e-9;
  return std::ceil(mark.outer_mm + 2 * (quiet_zone_mm(mark) + kTick_mm) - kRounding);
}

}  // namespace articam::markers
