#pragma once
/// @file  Where a circular mark is and how it is turned, from its image alone: both answers.

#include <array>
#include <cmath>

#include "core/math/least_squares.hpp"
#include "core/math/types.hpp"
#include "core/status.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/imaged_circle.hpp"
#include "core/vision/lens_ellipse.hpp"
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

/// An orthonormal basis, its third vector this unit vector, which does not lie in the plane Z = 0.
template <class S>
Mat<S, 3, 3> basis_along(const Vec<S, 3>& e3) noexcept {
  Mat<S, 3, 3> basis;
  basis.col(2) = e3;
  basis.col(0) = Vec<S, 3>{e3.z(), S(0), -e3.x()} / std::sqrt(e3.x() * e3.x() + e3.z() * e3.z());
  basis.col(1) = e3.cross(basis.col(0));
  return basis;
}

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
Result<CirclePoses<S>> circle_poses(const PlaneEllipse<S>& on_plane, S radius_m) noexcept {
  const bool is_ellipse = on_plane.M(0, 0) > S(0) && on_plane.M(1, 1) > S(0);
  if (!is_ellipse || !(radius_m > S(0)) || !math::is_finite(radius_m)) return Status::bad_argument;
  if (!math::all_finite(on_plane.centre) || !math::all_finite(on_plane.M)) return Status::bad_argument;

  // Axes along and across the ray to the ellipse's centre, where the dual cone  W W^T - e3 e3^T  is almost diagonal:
  // its small part keeps all digits.
  const Vec<S, 3> towards = on_plane.centre.homogeneous();
  const S distance = towards.norm();
  const Mat<S, 3, 3> axes = basis_along<S>(towards / distance);
  const Mat<S, 3, 2> W = (axes.template topRows<2>().transpose() * on_plane.M) / distance;
  Mat<S, 3, 3> dual = W.lazyProduct(W.transpose());
  dual(2, 2) -= S(1);
  const math::SymmetricEigen<S, 3> eigen(dual);

  // One eigenvalue is negative, -1 or nearly, its vector the cone's axis; the others are A^2 and B^2 times its size.
  int k3{}, kA{}, kB{};
  eigen.values.minCoeff(&k3);
  eigen.values.maxCoeff(&kA);
  kB = 3 - k3 - kA;
  const S A2 = -eigen.values[kA] / eigen.values[k3], B2 = -eigen.values[kB] / eigen.values[k3];
  if (!(B2 > S(0)) || k3 == kA) return Status::bad_argument;
  Vec<S, 3> e3 = axes * eigen.V.col(k3);
  const Vec<S, 3> e1 = axes * eigen.V.col(kB);
  if (e3.dot(towards) < S(0)) e3 = -e3;

  const S B = std::sqrt(B2);
  const S size = A2 * (S(1) + B2);
  const Vec<S, 3> aside = std::sqrt((A2 - B2) / size) * e1;
  const Vec<S, 3> along = std::sqrt(B2 * (S(1) + A2) / size) * e3;
  const Circle<S> one{radius_m * (along / B + B * aside), aside - along, radius_m};
  const Circle<S> other{radius_m * (along / B - B * aside), -aside - along, radius_m};
  if (!(one.centre.z() >= S(kMinDepth_m)) || !(other.centre.z() >= S(kMinDepth_m))) return Status::behind_camera;
  return CirclePoses<S>{{one, other}};
}

/// The same from a mark's image in pixels (Ellipse: Q16 px), lens distortion included.
/// Errors  as above, and outside_domain from the lens model.
template <class S>
Result<CirclePoses<S>> circle_poses(const Ellipse& image, S radius_m, const CameraModel<S>& camera) noexcept {
  const auto on_plane = undistorted_ellipse(image, camera);
  if (!on_plane.ok()) return on_plane.status();
  return circle_poses(on_plane.value(), radius_m);
}

}  // namespace articam::vision
