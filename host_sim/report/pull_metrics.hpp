#pragma once
/// @file  How well a robot has moved an object's joint, in numbers.

#include <span>
#include <string>
#include <vector>

#include "host_sim/loop/manipulation.hpp"

namespace articam::sim {

inline constexpr double kAtRest_s = 3;  ///< then a commanded step is over, whatever feeds it back

/// Lengths in mm, angles in mrad, by the unit of the joint.
struct PullMetrics {
  int commands{}, settled{};         ///< steps commanded; those that came to rest near their target
  double settling_s{};               ///< mean time of those from the command until near for good
  double overshoot{};                ///< largest way beyond a target, on the side away from where it came
  double error_rms{}, error_peak{};  ///< of the joint about its target, from kAtRest_s after a command on
  double told_rms{}, told_peak{};    ///< what the controller believed minus what was so, at control instants
  double jerk_rms{};                 ///< of the hand, m/s^3, while control is on
};

/// A robot's run by one feedback.
struct FeedbackRun {
  std::string feedback;  ///< as of `--mode`
  PullMetrics metrics;
  std::vector<ControlSample> samples;  ///< none where that feedback knows no such joint
};

/// The first command switches control on and is no step. `near`: so close for good is settled, m or rad.
PullMetrics evaluate_pull(std::span<const ControlSample> samples, std::span<const JointCommand> commands, double near,
                          double period_s);

}  // namespace articam::sim
