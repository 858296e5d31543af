#pragma once
/// @file  Estimates -> an MCAP file of ROS 2 messages, for Foxglove, PlotJuggler and ros2 bag.

#include <memory>
#include <string>

#include "tools/listen/mcap_writer.hpp"
#include "tools/listen/output.hpp"

namespace articam::listen {

/// /articam/estimate of every estimate; /joint_states, /articam/pose and /articam/pose_base of valid ones. log_time is
/// the receipt, publish_time the sending, header.stamp the capture, all on the host's clock.
class McapOutput : public Output {
 public:
  explicit McapOutput(std::unique_ptr<RecordFile> file);

  std::string take(const Heard& heard) override;
  std::string finish() override { return writer_.finish(); }

 private:
  McapWriter writer_;
};

}  // namespace articam::listen
