#include "host_sim/control/multi_robot_controller.hpp"

#include <algorithm>
#include <cmath>

namespace articam::sim {
namespace {

constexpr int kForce = 6;
constexpr double kGraspRate = 20;  ///< 1/s, how fast hand and handle are brought together again
constexpr double kCreep = 0.002;   ///< m/s or rad/s below which the model's friction fades

/// A twist or acceleration in other axes.
template <class Columns>
Columns turned(const Quat<double>& R, const Columns& columns) noexcept {
  const Mat<double, 3, 3> M = R.toRotationMatrix();
  Columns out = columns;
  for (int k = 0; k < columns.cols(); ++k) {
    out.template block<3, 1>(0, k) = M * columns.template block<3, 1>(0, k);
    out.template block<3, 1>(3, k) = M * columns.template block<3, 1>(3, k);
  }
  return out;
}

JointVec friction_of(const RigidBodyDynamics& object, const JointVec& rate) noexcept {
  JointVec force = JointVec::Zero(rate.size());
  for (int i = 0; i < rate.size(); ++i) {
    const MechanismJoint& joint = object.mechanism().of_value(i);
    force[i] = joint.damping * rate[i] + joint.friction * std::clamp(rate[i] / kCreep, -1.0, 1.0);
  }
  return force;
}

}  // namespace

MultiRobotController::MultiRobotController(const Mechanism& robot, const Mechanism& object, const Grasp& grasp,
                                           const Pose<double>& T_obj_base, const Vec<double, 3>& gravity_obj,
                                           const JointVec& q, double object_position, const ControlOptions& options)
    : robot_{robot, T_obj_base.R.conjugate() * gravity_obj},
      object_{object, gravity_obj},
      grasp_{grasp},
      T_obj_base_{T_obj_base},
      options_{options},
      posture_{q},
      object_position_{JointVec::Constant(1, object_position)},
      object_rate_{JointVec::Zero(1)},
      command_{q, JointVec::Zero(q.size()), JointVec::Zero(q.size())} {
  observe();
  command_.torque = robot_.bias();  // stands still
}

const ServoCommand& MultiRobotController::step(const JointFeedback& feedback, double target) noexcept {
  observe();
  const int n = static_cast<int>(posture_.size());
  put_tasks(feedback, target);
  put_motion();
  put_limits(feedback);
  JointVec acceleration;
  double object_acceleration = 0;
  if (solver_.solve(program_, solution_) == QpStatus::solved) {
    acceleration = solution_.x.head(n);
    object_acceleration = solution_.x[n];
    const JointVec on_hand = J_robot_.transpose() * solution_.x.tail<kForce>();
    command_.torque = robot_.mass_matrix() * acceleration + robot_.bias() + on_hand;
  } else {
    ++failures_;
    acceleration = -command_.qdot / options_.braking_s;
    command_.torque = robot_.mass_matrix() * acceleration + robot_.bias();
  }
  integrate(acceleration, object_acceleration);
  return command_;
}

/// Both models at the commanded state; the object moves as the hand does.
void MultiRobotController::observe() noexcept {
  robot_.update(command_.q, command_.qdot);
  J_robot_ = turned(T_obj_base_.R, robot_.jacobian(grasp_.hand));
  const Vec6 hand = turned(T_obj_base_.R, robot_.twist(grasp_.hand));
  object_.update(object_position_, object_rate_);
  J_object_ = object_.jacobian(grasp_.handle);
  const double along = J_object_.col(0).squaredNorm();
  object_rate_[0] = along > 0 ? J_object_.col(0).dot(hand) / along : 0;
  object_.update(object_position_, object_rate_);

  const Pose<double> at_hand = T_obj_base_ * robot_.pose(grasp_.hand), at_handle = object_.pose(grasp_.handle);
  Vec6 gap;
  gap << at_hand.t - at_handle.t, math::log_so3<double>(at_hand.R * at_handle.R.conjugate());
  const Vec6 drift = turned(T_obj_base_.R, robot_.drift(grasp_.hand)) - object_.drift(grasp_.handle);
  apart_ = drift + 2 * kGraspRate * (hand - object_.twist(grasp_.handle)) + kGraspRate * kGraspRate * gap;
}

void MultiRobotController::put_tasks(const JointFeedback& feedback, double target) noexcept {
  const int n = static_cast<int>(posture_.size()), size = n + 1 + kForce;
  program_.H.setZero(size, size);
  program_.g.setZero(size);
  const double damping = 2 * std::sqrt(options_.stiffness);
  const bool blind = feedback.age_s > options_.max_silence_s;
  const double pull = blind ? 0 : options_.stiffness * (feedback.position - target);
  program_.H(n, n) = options_.weight;
  program_.g[n] = options_.weight * (damping * object_rate_[0] + pull);
  const double posture_damping = 2 * std::sqrt(options_.posture_stiffness);
  for (int i = 0; i < n; ++i) {
    program_.H(i, i) = options_.posture_weight;
    const double wanted =
        -posture_damping * command_.qdot[i] - options_.posture_stiffness * (command_.q[i] - posture_[i]);
    program_.g[i] = -options_.posture_weight * wanted;
  }
  for (int i = n + 1; i < size; ++i) program_.H(i, i) = options_.force_weight;
}

void MultiRobotController::put_motion() noexcept {
  const int n = static_cast<int>(posture_.size()), size = n + 1 + kForce;
  program_.E.setZero(1 + kForce, size);
  program_.e.setZero(1 + kForce);
  program_.E(0, n) = object_.mass_matrix()(0, 0);
  program_.E.block(0, n + 1, 1, kForce) = -J_object_.transpose();
  program_.e[0] = -object_.bias()[0] - friction_of(object_, object_rate_)[0];
  program_.E.block(1, 0, kForce, n) = J_robot_;
  program_.E.block(1, n, kForce, 1) = -J_object_;
  program_.e.tail(kForce) = -apart_;
}

void MultiRobotController::put_limits(const JointFeedback& feedback) noexcept {
  const int n = static_cast<int>(posture_.size()), size = n + 1 + kForce;
  program_.C.setZero(4 * n + 2 + 2 * kForce, size);
  program_.c.setZero(program_.C.rows());
  rows_ = 0;
  const JointMat& M = robot_.mass_matrix();
  for (int i = 0; i < n; ++i) {
    const MechanismJoint& joint = robot_.mechanism().of_value(i);
    for (const double sign : {1.0, -1.0}) {  // sign (M qddot + h + J^T f) >= -limit
      program_.C.row(rows_).head(n) = sign * M.row(i);
      program_.C.row(rows_).tail(kForce) = sign * J_robot_.col(i).transpose();
      program_.c[rows_++] = -joint.max_effort - sign * robot_.bias()[i];
    }
    bound_acceleration(i, joint, command_.q[i], command_.qdot[i], joint.max_rate);
  }
  const MechanismJoint& grasped = object_.mechanism().of_value(0);
  bound_acceleration(n, grasped, feedback.position, object_rate_[0],
                     std::min(grasped.max_rate, options_.max_object_rate));
  for (int i = 0; i < kForce; ++i) {
    const double most = i < 3 ? options_.max_force : 0.1 * options_.max_force;
    add_row(n + 1 + i, 1, -most);
    add_row(n + 1 + i, -1, -most);
  }
}

/// The rate after this period stays within its limit, and within what is left of the way to the end of the joint.
void MultiRobotController::bound_acceleration(int column, const MechanismJoint& joint, double q, double qdot,
                                              double max_rate) noexcept {
  const double most = options_.max_acceleration;
  const double upper_rate = std::min(max_rate, (joint.q_max - q) / options_.braking_s);
  const double lower_rate = std::max(-max_rate, (joint.q_min - q) / options_.braking_s);
  const double upper = std::max((upper_rate - qdot) / options_.period_s, -most);
  const double lower = std::min((lower_rate - qdot) / options_.period_s, most);
  add_row(column, 1, std::max(std::min(lower, upper), -most));
  add_row(column, -1, -std::min(upper, most));
}

void MultiRobotController::add_row(int column, double coefficient, double bound) noexcept {
  program_.C(rows_, column) = coefficient;
  program_.c[rows_++] = bound;
}

void MultiRobotController::integrate(const JointVec& acceleration, double object_acceleration) noexcept {
  const double dt = options_.period_s;
  command_.q += dt * command_.qdot + 0.5 * dt * dt * acceleration;
  command_.qdot += dt * acceleration;
  object_position_[0] += dt * object_rate_[0] + 0.5 * dt * dt * object_acceleration;
}

}  // namespace articam::sim
