#include "host_sim/dynamics/rigid_body_dynamics.hpp"

namespace articam::sim {
namespace {

using Vec3 = Vec<double, 3>;

/// v x m, the rate of a twist m that is carried along by v.
Vec6 cross_motion(const Vec6& v, const Vec6& m) noexcept {
  const Vec3 w = v.tail<3>();
  Vec6 out;
  out << w.cross(m.head<3>()) + v.head<3>().cross(m.tail<3>()), w.cross(m.tail<3>());
  return out;
}

/// v x* f, the same of a force (f, moment) or momentum.
Vec6 cross_force(const Vec6& v, const Vec6& f) noexcept {
  const Vec3 w = v.tail<3>();
  Vec6 out;
  out << w.cross(f.head<3>()), w.cross(f.tail<3>()) + v.head<3>().cross(f.head<3>());
  return out;
}

/// An inertia written in {body} -> about the origin of {root}, in its axes.
Mat6 in_root(const Mat6& inertia, const Pose<double>& T_root_body) noexcept {
  Mat6 to_body = Mat6::Zero();
  const Mat<double, 3, 3> R_t = T_root_body.R.toRotationMatrix().transpose();
  to_body.topLeftCorner<3, 3>() = R_t;
  to_body.topRightCorner<3, 3>() = -R_t * math::hat<double>(T_root_body.t);
  to_body.bottomRightCorner<3, 3>() = R_t;
  return to_body.transpose() * inertia * to_body;
}

}  // namespace

RigidBodyDynamics::RigidBodyDynamics(const Mechanism& mechanism, const Vec3& gravity)
    : mechanism_{mechanism}, gravity_{gravity}, bodies_(mechanism.joints.size()) {
  const JointVec rest = JointVec::Zero(mechanism.num_values());
  update(rest, rest);
}

void RigidBodyDynamics::update(const JointVec& q, const JointVec& qdot) noexcept {
  for (std::size_t row = 0; row < bodies_.size(); ++row) move_body(row, q, qdot);
  gather();
}

void RigidBodyDynamics::move_body(std::size_t row, const JointVec& q, const JointVec& qdot) noexcept {
  const MechanismJoint& joint = mechanism_.joints[row];
  Body& body = bodies_[row];
  const Body* parent = joint.parent < 0 ? nullptr : &bodies_[static_cast<std::size_t>(joint.parent)];
  const Pose<double> T_root_joint =
      parent == nullptr ? joint.T_parent_joint : parent->T_root_body * joint.T_parent_joint;
  const Vec3 axis = T_root_joint.R * joint.axis;
  const double position = joint.ratio * q[joint.value] + joint.offset, rate = joint.ratio * qdot[joint.value];
  if (joint.kind == model::JointKind::prismatic) {
    body.axis << axis, Vec3::Zero();
    body.T_root_body = {T_root_joint.R, T_root_joint.t + axis * position};
  } else {
    body.axis << T_root_joint.t.cross(axis), axis;
    body.T_root_body = {T_root_joint.R * math::exp_so3<double>(joint.axis * position), T_root_joint.t};
  }
  body.twist = body.axis * rate;
  body.drift = Vec6::Zero();
  if (parent != nullptr) {
    body.drift = parent->drift + cross_motion(parent->twist, body.twist);
    body.twist += parent->twist;
  }
  body.composite = in_root(joint.inertia, body.T_root_body);
  Vec6 acceleration = body.drift;
  acceleration.head<3>() -= gravity_;  // as if {root} were lifted
  body.force = body.composite * acceleration + cross_force(body.twist, body.composite * body.twist);
}

/// From the leaves to the root: bodies add up, and each joint meets those above it.
void RigidBodyDynamics::gather() noexcept {
  const int nv = mechanism_.num_values();
  mass_matrix_.setZero(nv, nv);
  bias_.setZero(nv);
  for (std::size_t row = bodies_.size(); row-- > 0;) {
    const MechanismJoint& joint = mechanism_.joints[row];
    const Body& body = bodies_[row];
    const Vec6 momentum = body.composite * body.axis;  // of all below, by a unit rate
    for (int above = static_cast<int>(row); above >= 0;) {
      const MechanismJoint& other = mechanism_.joints[static_cast<std::size_t>(above)];
      const double m = joint.ratio * other.ratio * bodies_[static_cast<std::size_t>(above)].axis.dot(momentum);
      mass_matrix_(joint.value, other.value) += m;
      if (above != static_cast<int>(row)) mass_matrix_(other.value, joint.value) += m;
      above = other.parent;
    }
    mass_matrix_(joint.value, joint.value) += joint.ratio * joint.ratio * joint.rotor_inertia;
    bias_[joint.value] += joint.ratio * body.axis.dot(body.force);
    if (joint.parent < 0) continue;
    bodies_[static_cast<std::size_t>(joint.parent)].composite += body.composite;
    bodies_[static_cast<std::size_t>(joint.parent)].force += body.force;
  }
}

Pose<double> RigidBodyDynamics::pose(const MechanismLink& link) const noexcept {
  return link.body < 0 ? link.T_body_link : bodies_[static_cast<std::size_t>(link.body)].T_root_body * link.T_body_link;
}

JointJacobian RigidBodyDynamics::jacobian(const MechanismLink& link) const noexcept {
  JointJacobian J = JointJacobian::Zero(6, mechanism_.num_values());
  const Vec3 p = pose(link).t;
  for (int row = link.body; row >= 0;) {
    const MechanismJoint& joint = mechanism_.joints[static_cast<std::size_t>(row)];
    const Vec6& axis = bodies_[static_cast<std::size_t>(row)].axis;
    J.block<3, 1>(0, joint.value) += joint.ratio * (axis.head<3>() + axis.tail<3>().cross(p));
    J.block<3, 1>(3, joint.value) += joint.ratio * axis.tail<3>();
    row = joint.parent;
  }
  return J;
}

Vec6 RigidBodyDynamics::twist(const MechanismLink& link) const noexcept {
  if (link.body < 0) return Vec6::Zero();
  Vec6 v = bodies_[static_cast<std::size_t>(link.body)].twist;
  v.head<3>() += v.tail<3>().cross(pose(link).t);
  return v;
}

Vec6 RigidBodyDynamics::drift(const MechanismLink& link) const noexcept {
  if (link.body < 0) return Vec6::Zero();
  Vec6 a = bodies_[static_cast<std::size_t>(link.body)].drift;
  const Vec6 v = twist(link);
  // The spatial acceleration is of what passes the origin; the link's own point turns along with its velocity.
  a.head<3>() += a.tail<3>().cross(pose(link).t) + v.tail<3>().cross(v.head<3>());
  return a;
}

}  // namespace articam::sim
