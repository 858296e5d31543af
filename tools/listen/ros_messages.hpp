#pragma once
/// @file  Estimates as ROS 2 messages: their definitions, and their bytes in CDR.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "tools/listen/cdr.hpp"
#include "tools/listen/output.hpp"

namespace articam::listen {

/// As the schema encoding "ros2msg" wants it: the message, then every message that it uses.
struct MessageType {
  std::string_view name;
  std::string_view definition;
};
extern const MessageType kJointState;
extern const MessageType kPoseWithCovarianceStamped;
extern const MessageType kEstimate;  ///< articam_msgs/msg/Estimate, all that the board says

/// header.stamp of all is the capture time on the host's clock. The first three only of a valid estimate.
void put_joint_state(CdrWriter& out, const Heard& heard);
/// Pose of {obj} in frame_id "camera"; covariance of (t, rotation vector), both along the axes of that frame.
void put_pose_in_camera(CdrWriter& out, const Heard& heard);
/// The same in frame_id "base", the robot's control frame. Only where t_base_obj is there.
void put_pose_in_base(CdrWriter& out, const Heard& heard);
void put_estimate(CdrWriter& out, const Heard& heard);

}  // namespace articam::listen
