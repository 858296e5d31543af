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
  Vec<S, kNumJoints<M>> joints = math::zeros<Vec<S, kNumJoints<M>>>();  ///< rad or m, in the table's order
};

/// Step of size nv = 6 + n, ordered (t, rotation, joints), both in {cam}:
/// t += dt,  R = exp(dr) R,  joints += dj. Joint limits are not applied.
template <class M, class S>
Configuration<M, S> integrate(const Configuration<M, S>& q, const Vec<S, kDof<M>>& step) noexcept {
  const Vec<S, 3>& t = q.T_cam_obj.t;
  // One step of Newton's towards 1 / |R| keeps the product a unit quaternion over any number of steps.
  const Quat<S> R = math::exp_so3<S>({step[3], step[4], step[5]}) * q.T_cam_obj.R;
  const S scale = S(1.5) - S(0.5) * (R.w() * R.w() + R.x() * R.x() + R.y() * R.y() + R.z() * R.z());
  Vec<S, kNumJoints<M>> joints;
  for (Eigen::Index j = 0; j < kNumJoints<M>; ++j) joints[j] = q.joints[j] + step[6 + j];
  return {
      {{scale * R.w(), scale * R.x(), scale * R.y(), scale * R.z()}, {t[0] + step[0], t[1] + step[1], t[2] + step[2]}},
      joints};
}

/// The step that leads from one configuration to another: integrate(from, step) == to.
template <class M, class S>
Vec<S, kDof<M>> difference(const Configuration<M, S>& from, const Configuration<M, S>& to) noexcept {
  Vec<S, kDof<M>> step;
  const Vec<S, 3> turn = math::log_so3<S>(to.T_cam_obj.R * from.T_cam_obj.R.conjugate());
  for (Eigen::Index i = 0; i < 3; ++i) step[i] = to.T_cam_obj.t[i] - from.T_cam_obj.t[i], step[3 + i] = turn[i];
  for (Eigen::Index j = 0; j < kNumJoints<M>; ++j) step[6 + j] = to.joints[j] - from.joints[j];
  return step;
}

/// Each joint value, or the limit of the model that is nearest to it.
template <class M, class S>
Vec<S, kNumJoints<M>> within_limits(Vec<S, kNumJoints<M>> joints) noexcept {
  for (Eigen::Index j = 0; j < kNumJoints<M>; ++j) {
    const JointRow& row = kValueRows<M>[static_cast<std::size_t>(j)];
    const S low = static_cast<S>(row.q_min), high = static_cast<S>(row.q_max);
    joints[j] = joints[j] < low ? low : (joints[j] > high ? high : joints[j]);
  }
  return joints;
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
