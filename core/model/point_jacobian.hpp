#pragma once
/// @file  How the object's velocity moves one of its points: J_i of the paper's equation (3).

#include "core/model/configuration.hpp"
#include "core/model/forward_kinematics.hpp"
#include "core/model/joint_paths.hpp"

namespace articam::model {

/// J of one body:  (v_0, omega) = J qdot.  A point of the body at X in {cam} moves by v_0 + omega x X, so J
/// serves every point of interest on the body, and L_i with its six columns applies to it directly.
///
/// Shapes  J 6 x nv, qdot nv = 6 + n, ordered (t, rotation, joints).
/// Frames  the twist is taken at the origin of {cam} and written in {cam}.
/// Units   v_0 m/s, omega rad/s; joint rates rad/s or m/s.
/// Source  Paolillo et al., equation (3); the place of the twist is our reading of it.
template <class M, class S>
Mat<S, 6, kDof<M>> point_jacobian(const Kinematics<M, S>& kinematics, const Pose<S>& T_cam_obj, int body) noexcept {
  auto J = math::zeros<Mat<S, 6, kDof<M>>>();
  for (Eigen::Index i = 0; i < 6; ++i) J(i, i) = S(1);
  const math::Triple<S> t = math::to_triple(T_cam_obj.t);  // v_0 = t x omega: the base turns about {obj}
  J(0, 4) = -t.z, J(0, 5) = t.y, J(1, 3) = t.z, J(1, 5) = -t.x, J(2, 3) = -t.y, J(2, 4) = t.x;
  const math::Axes<S> R = math::axes_of(T_cam_obj.R.w(), T_cam_obj.R.x(), T_cam_obj.R.y(), T_cam_obj.R.z());
  for (int row = 0; row < kNumBodies<M>; ++row) {
    if (!moves<M>(row, body)) continue;
    const Twist<S>& twist = kinematics.joint_twist[static_cast<std::size_t>(row)];
    const S ratio = static_cast<S>(M::kJoints[static_cast<std::size_t>(row)].ratio);
    const math::Triple<S> omega = ratio * (R * math::to_triple(twist.angular));
    const math::Triple<S> linear = ratio * (R * math::to_triple(twist.linear)) + cross(t, omega);
    const int column = 6 + kValueOfRow<M>[static_cast<std::size_t>(row)];
    J(0, column) += linear.x, J(1, column) += linear.y, J(2, column) += linear.z;
    J(3, column) += omega.x, J(4, column) += omega.y, J(5, column) += omega.z;
  }
  return J;
}

}  // namespace articam::model
