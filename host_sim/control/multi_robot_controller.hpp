#pragma once
/// @file  One quadratic program for robot and object together.

#include "host_sim/control/quadratic_program.hpp"
#include "host_sim/dynamics/rigid_body_dynamics.hpp"

namespace articam::sim {

/// Where a hand holds an object.
struct Grasp {
  MechanismLink hand;    ///< of the robot
  MechanismLink handle;  ///< of the object: where the hand is, turned as the hand
};

/// The gains and weights of the tasks, and what the fingers may do.
struct ControlOptions {
  double period_s = 0.005;       ///< HRP-4's control runs at 200 Hz
  double stiffness = 25;         ///< kp of equation (8), 1/s^2: two equal poles at sqrt(kp)
  double weight = 1000;          ///< w_q of equation (8)
  double posture_stiffness = 4;  ///< 1/s^2
  double posture_weight = 0.1;
  double force_weight = 1e-4;     ///< keeps needless force out of the grasp, per N^2
  double max_force = 80;          ///< of each component that the hand may ask of the handle, N; moments a tenth, N m
  double max_object_rate = 0.06;  ///< m/s or rad/s
  double braking_s = 0.1;         ///< a joint this far in time from its limit brakes
  double max_acceleration = 30;   ///< rad/s^2
  double max_silence_s = 0.25;    ///< feedback older than that: stop
};

/// What is known of the object's joint at a control instant.
struct JointFeedback {
  double position{};  ///< of the task's joint, predicted to now, m or rad
  double age_s{};     ///< since it was measured
};

/// What a servo of the robot follows until the next command.
struct ServoCommand {
  JointVec q, qdot, torque;
};

/// The object is a passive robot beside the robot; the hand joins them:
///
///   unknown     x = (qddot_r, qddot_o, f), f the force and moment of the hand on the handle
///   least       w_q (qddot_o + 2 sqrt(kp) qdot_o + kp (q_1 - q_1,d))^2           task (8), squared
///               + w_p |qddot_r - posture|^2 + w_f |f|^2
///   where       M_o qddot_o + h_o + friction = J_o^T f                            the object has no motor
///               J_r qddot_r + drift_r = J_o qddot_o + drift_o - correction        hand and handle move as one
///               |M_r qddot_r + h_r + J_r^T f| <= torque limits                    the robot's motion, torques
///               eliminated joint limits of position and rate of both, as bounds of acceleration; |f| <= max_force
///
/// q_1 is what the eye says; qdot_o what the encoders say, through the grasp: they are quick and without noise, and
/// what they cannot know (backlash, slip, how the robot sways) is slow. The accelerations are integrated to what servos
/// follow, from the commands and not from the encoders.
/// Frames  {root} of the object for forces and the hand's motion. Units  SI.
class MultiRobotController {
 public:
  /// T_obj_base: where the robot believes to stand. q: its posture with the hand at the handle, where it begins and to
  /// which its posture task pulls. The object has one value.
  MultiRobotController(const Mechanism& robot, const Mechanism& object, const Grasp& grasp,
                       const Pose<double>& T_obj_base, const Vec<double, 3>& gravity_obj, const JointVec& q,
                       double object_position, const ControlOptions& options = {});

  /// One control period towards `target`.
  const ServoCommand& step(const JointFeedback& feedback, double target) noexcept;

  const ServoCommand& command() const noexcept { return command_; }
  /// The newest solution: accelerations and force.
  const QpVec& solution() const noexcept { return solution_.x; }
  const QuadraticProgram& program() const noexcept { return program_; }
  int failures() const noexcept { return failures_; }  ///< periods without a solution; the robot braked
  const RigidBodyDynamics& robot() const noexcept { return robot_; }
  const RigidBodyDynamics& object() const noexcept { return object_; }
  double object_rate() const noexcept { return object_rate_[0]; }  ///< by the encoders, through the grasp

 private:
  void observe() noexcept;
  void put_tasks(const JointFeedback& feedback, double target) noexcept;
  void put_motion() noexcept;
  void put_limits(const JointFeedback& feedback) noexcept;
  void bound_acceleration(int column, const MechanismJoint& joint, double q, double qdot, double max_rate) noexcept;
  void add_row(int column, double coefficient, double bound) noexcept;
  void integrate(const JointVec& acceleration, double object_acceleration) noexcept;

  RigidBodyDynamics robot_, object_;
  Grasp grasp_;
  Pose<double> T_obj_base_;
  ControlOptions options_;
  JointVec posture_;
  JointVec object_position_, object_rate_;  ///< where the hand has it, by the encoders
  ServoCommand command_;

  JointJacobian J_robot_, J_object_;  ///< of hand and handle, in {root} of the object
  Vec6 apart_;                        ///< what the grasp's accelerations must make up for
  QuadraticProgram program_;
  int rows_{};  ///< of C so far
  QpSolution solution_;
  DualActiveSet solver_;
  int failures_{};
};

}  // namespace articam::sim
