#pragma once
/// @file  Robot, object and controller in simulated time, and what the controller is told of the object.

#include <optional>
#include <span>
#include <vector>

#include "host_sim/control/multi_robot_controller.hpp"
#include "host_sim/world/robot_at_object.hpp"

namespace articam::sim {

/// From t_s on, the object's joint is wanted there, m or rad.
struct JointCommand {
  double t_s{}, target{};
};

/// What an eye says of the object's joint.
struct JointSighting {
  double t_s{};  ///< when it was so: mid-exposure
  double position{}, rate{};
};

/// One control period, at its end.
struct ControlSample {
  double t_s{};
  double target{};
  double position{};                                     ///< the true one
  double told{};                                         ///< what the controller believed
  Vec<double, 3> hand_velocity{Vec<double, 3>::Zero()};  ///< m/s, {base}
  double pull{};                                         ///< force of the hand on the handle, N
};

/// Time goes where advance_to() says; control periods and world steps happen on the way. Before the first command the
/// robot stands. Commands in the order of time.
class Manipulation {
 public:
  enum class Eye { sightings, truth };

  Manipulation(const Setting& setting, const WorldOptions& world, const ControlOptions& control,
               std::span<const JointCommand> commands, Eye eye);

  void advance_to(double t_s);
  /// From now on the controller goes by this.
  void see(const JointSighting& sighting) noexcept { sighting_ = sighting; }

  /// The object at an instant of the last kMemory_s, none later than now.
  struct Instant {
    double position{}, rate{};
    Pose<double> T_cam_obj;
    Vec6 twist;  ///< of {obj} in {cam}, as the tracker's qdot: by the sway
    ArmPoints arm_cam;
  };
  Instant at(double t_s) const noexcept;

  /// Nothing before control is switched on.
  std::optional<double> wanted_at(double t_s) const noexcept;

  RobotAtObject& world() noexcept { return world_; }
  const MultiRobotController& controller() const noexcept { return controller_; }
  const std::vector<ControlSample>& samples() const noexcept { return samples_; }
  static constexpr double kMemory_s = 1;

 private:
  void control();

  RobotAtObject world_;
  MultiRobotController controller_;
  std::vector<JointCommand> commands_;
  Eye eye_;
  double max_silence_s_;  ///< then the controller stops, and nothing is predicted further
  int steps_per_period_;
  long steps_{};
  JointSighting sighting_;
  struct Past {
    double position{}, rate{};
    ArmPoints arm_cam;
  };
  std::vector<Past> past_;  ///< of step k at k modulo its size
  std::vector<ControlSample> samples_;
};

}  // namespace articam::sim
