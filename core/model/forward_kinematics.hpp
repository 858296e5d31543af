#pragma once
/// @file  Joint values -> where every marker is and how every joint moves it, in the root frame {obj}.

#include <array>
#include <cstddef>

#include "core/math/se3.hpp"
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
Quat<S> to_quat(const std::array<double, 4>& wxyz) noexcept {
  return {static_cast<S>(wxyz[0]), static_cast<S>(wxyz[1]), static_cast<S>(wxyz[2]), static_cast<S>(wxyz[3])};
}

/// {joint} displaced by q, in {joint}.
template <class S>
Pose<S> displacement(const JointRow& row, S q) noexcept {
  const Vec<S, 3> axis = to_vec<S>(row.axis);
  if (row.kind == JointKind::prismatic) return {Quat<S>(S(1), S(0), S(0), S(0)), axis * q};
  return {math::exp_so3<S>(axis * q), Vec<S, 3>::Zero()};
}

/// kMoves<M>[joint][body + 1]: whether the joint stands between the root and the body.
template <class M>
constexpr auto joints_above() {
  std::array<std::array<bool, M::kJoints.size() + 1>, M::kJoints.size() + 1> above{};
  for (int body = 0; body < kNumBodies<M>; ++body) {
    for (int joint = body; joint >= 0; joint = M::kJoints[static_cast<std::size_t>(joint)].parent) {
      above[static_cast<std::size_t>(joint)][static_cast<std::size_t>(body + 1)] = true;
    }
  }
  return above;
}
template <class M>
inline constexpr auto kMoves = joints_above<M>();

/// Where the joint of a row stands.
template <class M, class S>
S joint_position(std::size_t row, const Vec<S, kNumJoints<M>>& joints) noexcept {
  const S value = joints[static_cast<Eigen::Index>(kValueOfRow<M>[row])];
  const JointRow& joint = M::kJoints[row];
  return joint.leader < 0 ? value : static_cast<S>(joint.ratio) * value + static_cast<S>(joint.offset);
}

}  // namespace detail

/// Whether the joint of a row moves the markers of a body (-1: the root, which no joint moves).
template <class M>
constexpr bool moves(int joint, int body) noexcept {
  return detail::kMoves<M>[static_cast<std::size_t>(joint)][static_cast<std::size_t>(body + 1)];
}

/// Joint values (rad or m, in the order of kValueRows) -> kinematics in {obj}. Cannot fail; values beyond the
/// limits are taken as they are.
template <class M, class S>
Kinematics<M, S> forward_kinematics(const Vec<S, kNumJoints<M>>& joints) noexcept {
  Kinematics<M, S> k;
  for (std::size_t j = 0; j < M::kJoints.size(); ++j) {
    const JointRow& row = M::kJoints[j];
    const Pose<S> T_parent_joint{detail::to_quat<S>(row.r_parent_joint_wxyz), detail::to_vec<S>(row.t_parent_joint_m)};
    const Pose<S> T_obj_joint =
        row.parent < 0 ? T_parent_joint : k.T_obj_body[static_cast<std::size_t>(row.parent)] * T_parent_joint;
    const Vec<S, 3> axis = T_obj_joint.R * detail::to_vec<S>(row.axis);
    k.joint_twist[j] = row.kind == JointKind::prismatic ? Twist<S>{axis, Vec<S, 3>::Zero()}
                                                        : Twist<S>{T_obj_joint.t.cross(axis), axis};
    k.T_obj_body[j] = T_obj_joint * detail::displacement<S>(row, detail::joint_position<M, S>(j, joints));
  }
  for (std::size_t m = 0; m < M::kMarkers.size(); ++m) {
    const MarkerRow& row = M::kMarkers[m];
    const Vec<S, 3> t = detail::to_vec<S>(row.t_body_m);
    const Vec<S, 3> n = detail::to_vec<S>(row.normal);
    k.markers[m] = {t, n};
    if constexpr (kNumBodies < M >> 0) {
      if (row.body < 0) continue;
      const Pose<S>& T_obj_body = k.T_obj_body[static_cast<std::size_t>(row.body)];
      k.markers[m] = {T_obj_body * t, T_obj_body.R * n};
    }
  }
  return k;
}

}  // namespace articam::model
