#pragma once
/// @file  One simulated run as plain numbers: what the report is made from.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/math/se3.hpp"
#include "core/tracker/estimate.hpp"
#include "core/vision/detection.hpp"

namespace articam::sim {

/// Pose of {obj} in {cam}; joints in the model's order, m or rad.
struct PlainConfiguration {
  Pose<double> T_cam_obj;
  std::vector<double> joints;
};

/// Standard deviations that an estimate claims: m, rad (see roll_pitch_yaw), and the joints' own units.
struct ClaimedErrors {
  Vec<double, 3> position{Vec<double, 3>::Zero()}, roll_pitch_yaw{Vec<double, 3>::Zero()};
  std::vector<double> joints;
};

struct FrameRecord {
  std::uint32_t frame{};
  double t_s{};
  PlainConfiguration truth;
  std::vector<double> true_joint_rates;  ///< per second
  tracker::TrackingStatus status{};
  tracker::Reason reason{};
  std::optional<PlainConfiguration> estimate;  ///< where valid
  std::optional<ClaimedErrors> claimed;        ///< of the estimate
  std::optional<PlainConfiguration> svd;       ///< the baseline, equation (7), where it saw enough rings
  std::optional<PlainConfiguration> rival;     ///< the tracker's other mode, from the same marks
  double error_norm{};                         ///< ||e||, metric image plane
  double rival_error_norm{};
  double rms_px{};
  std::vector<vision::Ellipse> seen;  ///< outer edges of the marks that were matched
  std::optional<double> wanted;       ///< of the joint that a robot pulls, while it is told to
  std::optional<double> nees;         ///< squared error by the estimate's own covariance
  double step_s{};                    ///< time from image to estimate on this machine
};

struct RunRecord {
  std::string scenario, summary, mode;
  std::string rival_mode;  ///< empty: none ran
  bool rendered{true};     ///< false: the tracker was given marks instead of images
  std::uint64_t seed{};
  double noise_grey{}, blur_px{};
  double rest_s{};  ///< how long nothing moves at the start
  int degrees_of_freedom{};
  int pulled_joint{-1};  ///< by a robot; -1: there is none
  std::vector<std::string> joint_names;
  std::vector<bool> joint_is_length;  ///< else an angle
  std::vector<FrameRecord> frames;
};

}  // namespace articam::sim
