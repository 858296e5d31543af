#pragma once
/// @file  Truth and estimate of one frame -> the plain record of the report.

#include <Eigen/Cholesky>
#include <optional>

#include "host_sim/report/roll_pitch_yaw.hpp"
#include "host_sim/report/run_record.hpp"
#include "host_sim/world/object_state.hpp"

namespace articam::sim {

template <class Model, class S>
PlainConfiguration plain(const model::Configuration<Model, S>& q) {
  PlainConfiguration out{{q.T_cam_obj.R.template cast<double>(), q.T_cam_obj.t.template cast<double>()}, {}};
  for (const S joint : q.joints) out.joints.push_back(static_cast<double>(joint));
  return out;
}

/// delta^T P^-1 delta; nothing where P has no inverse. For a true covariance its mean is the degrees of freedom.
template <int N>
std::optional<double> normalised_error_squared(const Mat<double, N, N>& P, const Vec<double, N>& delta) {
  const Eigen::LDLT<Mat<double, N, N>> factor(P);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0)) return std::nullopt;
  return delta.dot(factor.solve(delta));
}

template <int N>
ClaimedErrors claimed_errors(const Quat<double>& R, const Mat<double, N, N>& P) {
  const Vec<double, N> std = P.diagonal().cwiseMax(0.0).cwiseSqrt();
  ClaimedErrors claimed{std.template head<3>(), roll_pitch_yaw_std(R, P.template block<3, 3>(3, 3)), {}};
  claimed.joints.assign(std.data() + 6, std.data() + N);
  return claimed;
}

template <class Model, class S>
FrameRecord record_frame(const ObjectState<Model>& truth, const tracker::Estimate<Model, S>& estimate) {
  FrameRecord record;
  record.frame = estimate.frame;
  record.t_s = static_cast<double>(estimate.t_capture.ns) / 1e9;  // divided, as in estimates.csv: the same last digit
  record.truth = plain(truth.q);
  for (int j = 0; j < model::kNumJoints<Model>; ++j) record.true_joint_rates.push_back(truth.qdot[6 + j]);
  record.status = estimate.status;
  record.reason = estimate.reason;
  record.error_norm = static_cast<double>(estimate.error_norm);
  record.rms_px = static_cast<double>(estimate.rms_px);
  if (!estimate.valid) return record;
  record.estimate = plain(estimate.q);
  model::Configuration<Model, double> q;
  q.T_cam_obj = record.estimate->T_cam_obj;
  q.joints = estimate.q.joints.template cast<double>();
  const Mat<double, model::kDof<Model>, model::kDof<Model>> P = estimate.covariance.template cast<double>();
  record.claimed = claimed_errors<model::kDof<Model>>(q.T_cam_obj.R, P);
  record.nees = normalised_error_squared<model::kDof<Model>>(P, model::difference(q, truth.q));
  return record;
}

}  // namespace articam::sim
