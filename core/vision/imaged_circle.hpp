#pragma once
/// @file  A flat circular mark under perspective: the centre of its image, and how that moves.

#include "core/math/types.hpp"
#include "core/status.hpp"
#include "core/vision/interaction_matrix.hpp"

namespace articam::vision {

/// A circle in {cam}: centre (m), unit normal (either side), radius (m; 0 is a plain point).
template <class S>
struct Circle {
  Vec<S, 3> centre;
  Vec<S, 3> normal;
  S radius;
};

/// The image of a circle is an ellipse whose centre is not the projection of the circle's centre. With the dual
/// conic  C* = c c^T - r^2 (I - n n^T)  the centre is the pole of the line at infinity, M = C* e3:
///
///     M = c c_z + r^2 (n n_z - e3),    s = (M_x, M_y) / M_z
///
/// Shapes  s 2x1.  Frames  {cam}.  Units  s: metric image plane at Z = 1.
/// Errors  behind_camera when a part of the circle's neighbourhood reaches the plane Z = 0, or on NaN.
/// Source  Hartley & Zisserman, "Multiple view geometry", 2nd ed., section 2.2.3 (dual conics), derived for a circle.
template <class S>
Result<Vec<S, 2>> imaged_centre(const Circle<S>& circle) noexcept {
  const auto& [c, n, r] = circle;
  if (!(c.z() >= S(kMinDepth_m)) || !(c.z() > r)) return Status::behind_camera;
  const S r2 = r * r;
  const S m_z = c.z() * c.z() + r2 * (n.z() * n.z() - S(1));
  return Vec<S, 2>{(c.x() * c.z() + r2 * n.x() * n.z()) / m_z, (c.y() * c.z() + r2 * n.y() * n.z()) / m_z};
}

/// Interaction matrix of the imaged centre:  sdot = L v, v the twist of the camera relative to the object.
/// Compiled for float and double. With r = 0 it is interaction_matrix(s, c_z). Shapes, frames, units and errors as
/// there.
template <class S>
Result<Mat<S, 2, 6>> imaged_centre_interaction_matrix(const Circle<S>& circle) noexcept;

}  // namespace articam::vision
