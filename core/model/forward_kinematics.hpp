#pragma once
/// @file  Joint values -> where every marker is and how every joint moves it, in the root frame {obj}.

#include <array>
#include <cstddef>

#include "core/math/se3.hpp"
#include "core/model/body_places.hpp"
#include "core/model/model_table.hpp"

namespace articam::model {

/// The twist of a unit rate: a point at p moves by linear + angular x p. Both in the frame in which p
/// is written; linear is the velocity of the point of the body that passes its origin.
template <class S>
struct Twist {
  Vec<S, 3> linear{Vec<S, 3>::Zero()};   ///< m/s per unit rate
  Vec<S, 3> angular{Vec<S, 3>::Zero()};  ///< rad/s per unit rate

  Vec<S, 3> velocity_of(const Vec<S, 3>& p) const noexcept { return linear + angular.cross(p); }
};

template <class S>
struct MarkerPlace {
  Vec<S, 3> centre;  ///< m, {obj}
  Vec<S, 3> normal;  ///< outward unit normal, {obj}
};

template <class M, class S>
struct Kinematics {
  std::array<Pose<S>, static_cast<std::size_t>(kNumBodies<M>)> T_obj_body{};
  std::array<Twist<S>, static_cast<std::size_t>(kNumBodies<M>)> joint_twist{};  ///< of each row, {obj}, at its origin
  std::array<MarkerPlace<S>, static_cast<std::size_t>(kNumMarkers<M>)> markers{};
};

namespace detail {

template <class S>
Vec<S, 3> to_vec(const std::array<double, 3>& a) noexcept {
  return {static_cast<S>(a[0]), static_cast<S>(a[1]), static_cast<S>(a[2])};
}

template <class S>
Pose<S> to_pose(const BodyPlace<S>& place) noexcept {
  Mat<S, 3, 3> R;
  const math::Triple<S>* const axes[]{&place.axes.x, &place.axes.y, &place.axes.z};
  for (Eigen::Index i = 0; i < 3; ++i) R(0, i) = axes[i]->x, R(1, i) = axes[i]->y, R(2, i) = axes[i]->z;
  return {Quat<S>(R), math::to_vec(place.origin)};
}

}  // namespace detail

/// Joint values (rad or m, in the order of kValueRows) -> kinematics in {obj}. Cannot fail; values beyond the
/// limits are taken as they are.
template <class M, class S>
Kinematics<M, S> forward_kinematics(const Vec<S, kNumJoints<M>>& joints) noexcept {
  BodyPlaces<M, S> places;
  place_bodies<M, S>(math::kSameAxes<S>, joints, places);
  Kinematics<M, S> k;
  for (std::size_t j = 0; j < M::kJoints.size(); ++j) {
    const BodyPlace<S>& place = places[j + 1];
    k.joint_twist[j].linear = to_vec(place.motion.linear);
    if (M::kJoints[j].kind != JointKind::prismatic) k.joint_twist[j].angular = to_vec(place.motion.angular);
    k.T_obj_body[j] = detail::to_pose(place);
  }
  for (std::size_t m = 0; m < M::kMarkers.size(); ++m) {
    const MarkerRow& row = M::kMarkers[m];
    const BodyPlace<S>& body = places[static_cast<std::size_t>(row.body + 1)];
    k.markers[m] = {to_vec(place_point(body, row.body < 0, row.t_body_m)), to_vec(along(body.axes, row.normal))};
  }
  return k;
}

}  // namespace articam::model
