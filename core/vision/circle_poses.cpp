#include "core/vision/circle_poses.hpp"

#include <cmath>

#include "core/math/least_squares.hpp"
#include "core/vision/lens_ellipse.hpp"

namespace articam::vision {
namespace {

/// An orthonormal basis, its third vector this unit vector, which does not lie in the plane Z = 0.
template <class S>
Mat<S, 3, 3> basis_along(const Vec<S, 3>& e3) noexcept {
  Mat<S, 3, 3> basis;
  basis.col(2) = e3;
  basis.col(0) = Vec<S, 3>{e3.z(), S(0), -e3.x()} / std::sqrt(e3.x() * e3.x() + e3.z() * e3.z());
  basis.col(1) = e3.cross(basis.col(0));
  return basis;
}

}  // namespace

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

template <class S>
Result<CirclePoses<S>> circle_poses(const Ellipse& image, S radius_m, const CameraModel<S>& camera) noexcept {
  const auto on_plane = undistorted_ellipse(image, camera);
  if (!on_plane.ok()) return on_plane.status();
  return circle_poses(on_plane.value(), radius_m);
}

template Result<CirclePoses<float>> circle_poses(const PlaneEllipse<float>&, float) noexcept;
template Result<CirclePoses<double>> circle_poses(const PlaneEllipse<double>&, double) noexcept;
template Result<CirclePoses<float>> circle_poses(const Ellipse&, float, const CameraModel<float>&) noexcept;
template Result<CirclePoses<double>> circle_poses(const Ellipse&, double, const CameraModel<double>&) noexcept;

}  // namespace articam::vision
