#pragma once
/// @file  A solid, or a mark on one, and where a line of sight meets it.

#include <array>
#include <optional>

#include "core/math/se3.hpp"

namespace articam::picture {

using Vec3 = Vec<double, 3>;

/// Red, green, blue, 0 to 1.
using Colour = std::array<double, 3>;

enum class Form {
  box,       ///< size: its edges
  cylinder,  ///< along z; size: diameter twice, length
  sphere,    ///< size: diameter three times
  mark,      ///< flat, z outwards; size: diameters of card, mark and hole
};

/// Frames  {shape}: its middle. Units  m.
struct Shape {
  Form form{};
  Pose<double> T_cam_shape{};
  Vec3 size{Vec3::Zero()};
  Colour colour{};
  Colour ink{};    ///< of a mark: between hole and edge; its colour is that of the card
  int marker{-1};  ///< of a mark: index in the model's table
};

/// The points origin + t direction, t > 0. Frames  {cam}, the direction of any length.
struct Ray {
  Vec3 origin, direction;
};

struct Hit {
  double t{};
  Vec3 normal_cam;  ///< unit, out of the solid
  Colour colour;
};

/// The nearest place where the ray enters the shape; nothing when it misses, or starts inside. A mark is seen from its
/// front only.
std::optional<Hit> meet(const Ray& ray, const Shape& shape);

}  // namespace articam::picture
