#pragma once
/// @file  How the object's velocity moves one of its points: J_i of the paper's equation (3).

#include "core/model/configuration.hpp"
#include "core/model/forward_kinematics.hpp"

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
  Mat<S, 6, kDof<M>> J = Mat<S, 6, kDof<M>>::Zero();
  J.template block<3, 3>(0, 0).setIdentity();
  J.template block<3, 3>(0, 3) = math::hat<S>(T_cam_obj.t);  // v_0 = t x omega: the base turns about {obj}
  J.template block<3, 3>(3, 3).setIdentity();
  for (int row = 0; row < kNumBodies<M>; ++row) {
    if (!moves<M>(row, body)) continue;
    const Twist<S>& twist = kinematics.joint_twist[static_cast<std::size_t>(row)];
    const S ratio = static_cast<S>(M::kJoints[static_cast<std::size_t>(row)].ratio);
    const Vec<S, 3> omega = T_cam_obj.R * twist.angular;
    const int column = 6 + kValueOfRow<M>[static_cast<std::size_t>(row)];
    J.template block<3, 1>(0, column) += ratio * (T_cam_obj.R * twist.linear + T_cam_obj.t.cross(omega));
    J.template block<3, 1>(3, column) += ratio * omega;
  }
  return J;
}

}  // namespace articam::model
