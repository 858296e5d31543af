#include "host_sim/world/robot_at_object.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace articam::sim {
namespace {

constexpr double kDt = WorldOptions::kStep_s;

Vec6 turned(const Quat<double>& R, const Vec6& v) noexcept {
  Vec6 out;
  out << R * Vec<double, 3>{v.head<3>()}, R * Vec<double, 3>{v.tail<3>()};
  return out;
}

}  // namespace

Setting make_setting(const Mechanism& robot, const Mechanism& object, const std::string& handle_link,
                     const Vec<double, 3>& handle_m, double object_position, const JointVec& posture,
                     const Quat<double>& R_obj_base, const Pose<double>& T_cam_obj) {
  constexpr double kGravity = 9.80665;
  Setting setting{robot, object, {robot.link("hand"), object.link(handle_link)}, {}, {}, {}, posture, object_position};
  setting.gravity_obj = R_obj_base * Vec<double, 3>{0, 0, -kGravity};
  RigidBodyDynamics arm{robot, Vec<double, 3>::Zero()}, thing{object, Vec<double, 3>::Zero()};
  arm.update(posture, JointVec::Zero(posture.size()));
  thing.update(JointVec::Constant(1, object_position), JointVec::Zero(1));
  const Pose<double> T_base_hand = arm.pose(setting.grasp.hand), T_obj_link = thing.pose(setting.grasp.handle);
  setting.T_obj_base = {R_obj_base, T_obj_link * handle_m - R_obj_base * T_base_hand.t};
  const Pose<double> T_link_hand = T_obj_link.inverse() * (setting.T_obj_base * T_base_hand);
  setting.grasp.handle.T_body_link = setting.grasp.handle.T_body_link * T_link_hand;
  setting.T_base_cam = setting.T_obj_base.inverse() * T_cam_obj.inverse();
  return setting;
}

std::vector<Limb> limbs_of(const ArmPoints& arm_cam) {
  const auto& [shoulder, elbow, wrist, hand] = arm_cam;
  return {{shoulder, elbow, 0.05}, {elbow, wrist, 0.04}, {wrist, hand, 0.025}};
}

RobotAtObject::RobotAtObject(const Setting& setting, const WorldOptions& options)
    : setting_{setting},
      options_{options},
      sway_{options.sway, options.seed},
      fingers_{options.fingers},
      robot_{setting.robot, setting.T_obj_base.R.conjugate() * setting.gravity_obj},
      object_{setting.object, setting.gravity_obj},
      arm_links_{setting.robot.link("upper_arm"), setting.robot.link("forearm"), setting.robot.link("wrist"),
                 setting.grasp.hand},
      q_{setting.posture},
      qdot_{JointVec::Zero(setting.posture.size())},
      object_q_{JointVec::Constant(1, setting.object_position)},
      object_rate_{JointVec::Zero(1)} {
  robot_.update(q_, qdot_);
  const JointVec inertia = robot_.mass_matrix().diagonal();
  servo_stiffness_ = options.servo_bandwidth * options.servo_bandwidth * inertia;
  servo_damping_ = 2 * options.servo_bandwidth * inertia;
  meet();
}

Pose<double> RobotAtObject::T_cam_obj(double t_s) const noexcept {
  return (setting_.T_obj_base * sway_.at(t_s).pose * setting_.T_base_cam).inverse();
}

ArmPoints RobotAtObject::arm_cam() const noexcept {
  const Pose<double> T_cam_base = setting_.T_base_cam.inverse();
  ArmPoints points;
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = T_cam_base * robot_.pose(arm_links_[i]).t;
  return points;
}

void RobotAtObject::step(const ServoCommand& command, double since_command_s) noexcept {
  move_robot(command, since_command_s);
  move_object();
  ++steps_;
  meet();
}

/// Where the hand now is at the handle, and what they do to each other.
void RobotAtObject::meet() noexcept {
  robot_.update(q_, qdot_);
  object_.update(object_q_, object_rate_);
  const Sway::Motion sway = sway_.at(t_s());
  T_obj_base_ = setting_.T_obj_base * sway.pose;
  const Pose<double> in_base = robot_.pose(setting_.grasp.hand), at_hand = T_obj_base_ * in_base;
  const Pose<double> at_handle = object_.pose(setting_.grasp.handle);

  Vec6 carried = turned(setting_.T_obj_base.R, sway.twist);  // of {base}
  carried.head<3>() += Vec<double, 3>{carried.tail<3>()}.cross(at_hand.t - T_obj_base_.t);
  const Vec6 rate =
      turned(T_obj_base_.R, robot_.twist(setting_.grasp.hand)) + carried - object_.twist(setting_.grasp.handle);

  // The play is along the axes of the body that is held, not along those of the hand.
  const Quat<double> R_body_obj = object_.pose({"", setting_.grasp.handle.body, {}}).R.conjugate();
  hand_.offset_m = R_body_obj * (at_hand.t - at_handle.t);
  hand_.turn_rad = R_body_obj * math::log_so3<double>(at_hand.R * at_handle.R.conjugate());
  hand_.rate = turned(R_body_obj, rate);
  force_ = turned(R_body_obj.conjugate(), fingers_.force(hand_));
}

void RobotAtObject::move_robot(const ServoCommand& command, double since_command_s) noexcept {
  const Vec6 on_hand = turned(T_obj_base_.R.conjugate(), force_);
  JointVec torque = command.torque + servo_stiffness_.cwiseProduct(command.q + since_command_s * command.qdot - q_) +
                    servo_damping_.cwiseProduct(command.qdot - qdot_);
  for (int i = 0; i < torque.size(); ++i) {
    const MechanismJoint& joint = setting_.robot.of_value(i);
    torque[i] = std::clamp(torque[i], -joint.max_effort, joint.max_effort) - joint.damping * qdot_[i];
  }
  torque -= robot_.bias();
  torque -= robot_.jacobian(setting_.grasp.hand).transpose() * on_hand;
  qdot_ += kDt * robot_.mass_matrix().llt().solve(torque);
  q_ += kDt * qdot_;
}

/// One joint: friction takes what velocity it can within the step, so that it holds and does not chatter.
void RobotAtObject::move_object() noexcept {
  const MechanismJoint& joint = setting_.object.of_value(0);
  const double inertia = object_.mass_matrix()(0, 0);
  const double pull = object_.jacobian(setting_.grasp.handle).col(0).dot(force_);
  const double damping = options_.friction_factor * joint.damping;
  double rate = object_rate_[0] + kDt * (pull - object_.bias()[0] - damping * object_rate_[0]) / inertia;
  const double held = kDt * options_.friction_factor * joint.friction / inertia;
  rate = rate > 0 ? std::max(rate - held, 0.0) : std::min(rate + held, 0.0);
  const double next = object_q_[0] + kDt * rate;
  const double stopped = std::clamp(next, joint.q_min, joint.q_max);
  object_rate_[0] = stopped == next ? rate : 0;
  object_q_[0] = stopped;
}

}  // namespace articam::sim
