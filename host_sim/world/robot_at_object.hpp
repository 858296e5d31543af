#pragma once
/// @file  A robot that stands, sways and holds an object by its handle: what really happens, in small steps.

#include <array>
#include <string>
#include <vector>

#include "host_sim/control/multi_robot_controller.hpp"
#include "host_sim/world/fingers.hpp"
#include "host_sim/world/limb.hpp"
#include "host_sim/world/sway.hpp"

namespace articam::sim {

/// Who stands where, at rest. {obj} is the world; the robot's {base} is {chest} of the arm.
struct Setting {
  Mechanism robot, object;     ///< the object with one moving joint
  Grasp grasp;                 ///< where the hand is on the handle
  Pose<double> T_obj_base;     ///< while nobody sways
  Pose<double> T_base_cam;     ///< the camera sways with the robot
  Vec<double, 3> gravity_obj;  ///< m/s^2
  JointVec posture;            ///< of the robot, its hand at the handle
  double object_position{};    ///< m or rad
};

/// The setting of an arm that takes hold of `handle_m` (in the object's link) in that posture.
/// T_cam_obj: what the camera sees while nobody sways. R_obj_base: how the robot faces the object; its z is up.
Setting make_setting(const Mechanism& robot, const Mechanism& object, const std::string& handle_link,
                     const Vec<double, 3>& handle_m, double object_position, const JointVec& posture,
                     const Quat<double>& R_obj_base, const Pose<double>& T_cam_obj);

/// Shoulder, elbow, wrist and hand, m.
using ArmPoints = std::array<Vec<double, 3>, 4>;

/// Upper arm, forearm and hand between them, as thick as clothed ones; {cam}.
std::vector<Limb> limbs_of(const ArmPoints& arm_cam);

struct WorldOptions {
  FingerOptions fingers;
  SwayOptions sway;
  double friction_factor = 1.3;  ///< the object's true friction by the model's
  double servo_bandwidth = 90;   ///< rad/s
  std::uint64_t seed = 1;
  static constexpr double kStep_s = 0.001;
};

/// Rigid bodies, servos that follow commands as far as their torque goes, fingers with play, friction that holds,
/// stops. The sway moves what is mounted on the robot; its own accelerations (below 0.03 m/s^2) load nothing.
class RobotAtObject {
 public:
  RobotAtObject(const Setting& setting, const WorldOptions& options);

  /// One step of kStep_s. `since_command_s`: how far the servos have gone on from the command.
  void step(const ServoCommand& command, double since_command_s) noexcept;

  double t_s() const noexcept { return static_cast<double>(steps_) * WorldOptions::kStep_s; }
  double object_position() const noexcept { return object_q_[0]; }
  double object_rate() const noexcept { return object_rate_[0]; }
  const JointVec& robot_position() const noexcept { return q_; }
  const JointVec& robot_rate() const noexcept { return qdot_; }
  const Vec6& force() const noexcept { return force_; }  ///< of the hand on the handle, {obj}
  const Fingers& fingers() const noexcept { return fingers_; }
  /// Of the hand on the handle since it took hold, {handle}.
  const HandAtHandle& hand() const noexcept { return hand_; }
  Vec6 hand_twist() const noexcept { return robot_.twist(setting_.grasp.hand); }  ///< in {base}
  Pose<double> T_cam_obj(double t_s) const noexcept;
  ArmPoints arm_cam() const noexcept;  ///< {cam} is mounted on the robot, as the arm is

  /// A fault of the object: its friction by the model's, from now on.
  void set_friction_factor(double factor) noexcept { options_.friction_factor = factor; }

 private:
  void meet() noexcept;
  void move_robot(const ServoCommand& command, double since_command_s) noexcept;
  void move_object() noexcept;

  Setting setting_;
  WorldOptions options_;
  Sway sway_;
  Fingers fingers_;
  RigidBodyDynamics robot_, object_;
  std::array<MechanismLink, 4> arm_links_;
  JointVec q_, qdot_, object_q_, object_rate_;
  JointVec servo_stiffness_, servo_damping_;
  Pose<double> T_obj_base_;
  HandAtHandle hand_{};
  Vec6 force_{Vec6::Zero()};
  long steps_{};
};

}  // namespace articam::sim
