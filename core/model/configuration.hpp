#pragma once
/// @file  Where the object is: the pose of its base and its joint values.

#include <array>

#include "core/math/se3.hpp"
#include "core/model/model_table.hpp"
#include "core/status.hpp"

namespace articam::model {

/// q of the paper's equation (1), its base kept as a pose.
template <class M, class S>
struct Configuration {
  Pose<S> T_cam_obj{};
  Vec<S, kNumJoints<M>> joints{Vec<S, kNumJoints<M>>::Zero()};  ///< rad or m, in the table's order
};

/// Step of size nv = 6 + n, ordered (t, rotation, joints), both in {cam}:
/// t += dt,  R = exp(dr) R,  joints += dj. Joint limits are not applied.
template <class M, class S>
Configuration<M, S> integrate(const Configuration<M, S>& q, const Vec<S, kDof<M>>& step) noexcept {
  Configuration<M, S> moved;
  moved.T_cam_obj.t = q.T_cam_obj.t + step.template head<3>();
  // One renormalisation keeps the product a unit quaternion over any number of steps.
  moved.T_cam_obj.R = (math::exp_so3<S>(step.template segment<3>(3)) * q.T_cam_obj.R).normalized();
  moved.joints = q.joints + step.template tail<kNumJoints<M>>();
  return moved;
}

/// The step that leads from one configuration to another: integrate(from, step) == to.
template <class M, class S>
Vec<S, kDof<M>> difference(const Configuration<M, S>& from, const Configuration<M, S>& to) noexcept {
  Vec<S, kDof<M>> step;
  step.template head<3>() = to.T_cam_obj.t - from.T_cam_obj.t;
  step.template segment<3>(3) = math::log_so3<S>(to.T_cam_obj.R * from.T_cam_obj.R.conjugate());
  step.template tail<kNumJoints<M>>() = to.joints - from.joints;
  return step;
}

/// From (px, py, pz, qw, qx, qy, qz, q1, ...), the order of q0 and of estimates.csv. The quaternion is
/// normalised. Errors  bad_argument when a number is not finite or the quaternion is zero.
template <class M, class S>
Result<Configuration<M, S>> from_numbers(const std::array<double, 7 + kNumJoints<M>>& numbers) noexcept {
  for (const double x : numbers) {
    if (!math::is_finite(x)) return Status::bad_argument;
  }
  const Quat<double> r{numbers[3], numbers[4], numbers[5], numbers[6]};
  if (!(r.norm() > 1e-6)) return Status::bad_argument;
  Configuration<M, S> q;
  q.T_cam_obj.t = Vec<double, 3>{numbers[0], numbers[1], numbers[2]}.template cast<S>();
  q.T_cam_obj.R = r.normalized().template cast<S>();
  for (int i = 0; i < kNumJoints<M>; ++i) q.joints[i] = static_cast<S>(numbers[static_cast<std::size_t>(7 + i)]);
  // A double beyond a float's range has become infinite.
  if (!math::all_finite(q.T_cam_obj.t) || !math::all_finite(q.joints)) return Status::bad_argument;
  return q;
}

}  // namespace articam::model
