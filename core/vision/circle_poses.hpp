#pragma once
/// @file  Where a circular mark is and how it is turned, from its image alone: both answers. Compiled for float and
/// double.

#include <array>

#include "core/math/types.hpp"
#include "core/status.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/imaged_circle.hpp"
#include "core/vision/plane_ellipse.hpp"

namespace articam::vision {

/// The two circles of one radius that have the same image, each with its outward normal (towards the camera).
/// They are mirror images by the plane through the focal point that holds the axis of the cone of rays and the
/// ellipse's major axis: equally far, tilted by the same angle to that axis, one circle where that angle is 0.
template <class S>
struct CirclePoses {
  std::array<Circle<S>, 2> solutions;

  S range_m() const noexcept { return solutions[0].centre.norm(); }  ///< from the focal point, the same for both
  /// Between the two centres, which are of second order in radius / range apart.
  Vec<S, 3> mean_centre() const noexcept { return S(0.5) * (solutions[0].centre + solutions[1].centre); }
};

/// The circles seen as this ellipse. The cone of rays through it has the semi-axes A >= B at distance 1 along its own
/// axis e3; with e1 along B, it is cut in circles by the planes of normals -+sin(tilt) e1 - cos(tilt) e3,
///
///     sin^2 = (A^2 - B^2) / (A^2 (1 + B^2)),    cos^2 = B^2 (1 + A^2) / (A^2 (1 + B^2)),
///     centre = radius (-+B sin(tilt) e1 + cos(tilt) / B e3)
///
/// Exact. The tilt enters by its square: near 0 an error d of B / A turns the normals by about sqrt(2 d).
/// Frames  {cam}.  Units  m; ellipse on the metric plane Z = 1.
/// Errors  bad_argument for an empty ellipse, a radius that is not positive, or NaN; behind_camera when the circle's
///         centre is not in front.
/// Source  Derived from the dual conic  c c^T - r^2 (I - n n^T)  (imaged_circle.hpp); the two solutions are those of
///         Forsyth et al., "Invariant descriptors for 3-D object recognition and pose", IEEE PAMI 13(10), 1991.
template <class S>
Result<CirclePoses<S>> circle_poses(const PlaneEllipse<S>& on_plane, S radius_m) noexcept;

/// The same from a mark's image in pixels (Ellipse: Q16 px), lens distortion included.
/// Errors  as above, and outside_domain from the lens model.
template <class S>
Result<CirclePoses<S>> circle_poses(const Ellipse& image, S radius_m, const CameraModel<S>& camera) noexcept;

}  // namespace articam::vision
