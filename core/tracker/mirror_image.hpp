#pragma once
/// @file  The other way to see the same marks: a flat object and its mirror image differ by perspective only.

#include "core/tracker/hypothesis.hpp"
#include "core/tracker/vvs.hpp"

namespace articam::tracker {

/// These variances (m^2, rad^2) for the pose, and for the joints those of an even distribution over their range.
template <class M, class S>
Vec<S, model::kDof<M>> pose_and_range(S place, S turn) noexcept {
  Vec<S, model::kDof<M>> variance;
  for (int i = 0; i < 6; ++i) variance[i] = i < 3 ? place : turn;
  for (int j = 0; j < model::kNumJoints<M>; ++j) {
    const S length = joint_range<M, S>(j).length();
    variance[6 + j] = length * length / S(12) + S(1e-6);
  }
  return variance;
}

/// A wide prior about q for the pose, and for the joints their range.
template <class M, class S>
Prior<M, S> open_prior(const model::Configuration<M, S>& q) noexcept {
  return independent_prior<M, S>(q, pose_and_range<M, S>(S(0.25), S(1)));  // 0.5 m
}

/// A prior that holds what few marks leave open: a pose from two marks is known to some centimetres and degrees.
template <class M, class S>
Prior<M, S> held_prior(const model::Configuration<M, S>& q) noexcept {
  return independent_prior<M, S>(q, pose_and_range<M, S>(S(0.0025), S(0.04)));  // 5 cm, 0.2 rad
}

/// The configuration whose depths about the middle of its paired markers are reversed: for markers in one plane of
/// normal n, seen along u, the turn  (I - 2 u u^T)(I - 2 n n^T)  about that middle.
/// Errors  too_few_features without a pair; ill_conditioned when it is the same within a degree.
template <class M, class S>
Result<model::Configuration<M, S>> mirror_image(const Hypothesis<M, S>& hypothesis) noexcept {
  const auto kinematics = model::forward_kinematics<M, S>(hypothesis.q.joints);
  Vec<S, 3> middle = Vec<S, 3>::Zero(), normals = Vec<S, 3>::Zero();
  int n_markers = 0;
  for (std::size_t m = 0; m < hypothesis.sighting.size(); ++m) {
    // The anchor's cluster alone: what joints carry finds its own place.
    if (hypothesis.sighting[m] < 0 || !is_placed<M>(m, hypothesis.anchor, 0)) continue;
    middle += hypothesis.q.T_cam_obj * kinematics.markers[m].centre;
    normals += hypothesis.q.T_cam_obj.R * kinematics.markers[m].normal;
    ++n_markers;
  }
  if (n_markers == 0 || !(normals.squaredNorm() > S(0))) return Status::too_few_features;
  middle /= static_cast<S>(n_markers);
  const Vec<S, 3> u = middle / middle.norm(), n = normals / normals.norm();
  // The product of two reflections: twice the turn from n to -u, as a quaternion (u . n, n x u) up to its sign.
  const Vec<S, 3> axis = n.cross(u);
  if (!(axis.squaredNorm() > S(3e-4))) return Status::ill_conditioned;
  const Quat<S> turn = Quat<S>(u.dot(n), axis.x(), axis.y(), axis.z()).normalized();
  model::Configuration<M, S> q = hypothesis.q;
  q.T_cam_obj.R = (turn * q.T_cam_obj.R).normalized();
  q.T_cam_obj.t = middle + turn * Vec<S, 3>(hypothesis.q.T_cam_obj.t - middle);
  return q;
}

}  // namespace articam::tracker
