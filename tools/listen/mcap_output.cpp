#include "tools/listen/mcap_output.hpp"

#include <cstddef>
#include <utility>

#include "tools/listen/ros_messages.hpp"

namespace articam::listen {
namespace {

struct Topic {
  std::string_view name;
  const MessageType& type;
  void (*put)(CdrWriter&, const Heard&);
  bool (*has)(const wire::EstimateMessage&);
};

const Topic kTopics[]{
    {"/articam/estimate", kEstimate, put_estimate, [](const auto&) { return true; }},
    {"/joint_states", kJointState, put_joint_state, [](const auto& e) { return e.valid; }},
    {"/articam/pose", kPoseWithCovarianceStamped, put_pose_in_camera, [](const auto& e) { return e.valid; }},
    {"/articam/pose_base", kPoseWithCovarianceStamped, put_pose_in_base,
     [](const auto& e) { return !e.t_base_obj.empty(); }},
};

}  // namespace

McapOutput::McapOutput(std::unique_ptr<RecordFile> file) : writer_{std::move(file)} {
  for (const Topic& topic : kTopics) {
    static_cast<void>(writer_.add_topic(topic.name, topic.type.name, topic.type.definition));  // take() tells
  }
}

std::string McapOutput::take(const Heard& heard) {
  for (std::size_t i = 0; i < std::size(kTopics); ++i) {
    if (!kTopics[i].has(heard.estimate)) continue;
    CdrWriter cdr;
    kTopics[i].put(cdr, heard);
    const McapWriter::Message message{i, heard.estimate.number, heard.times.receipt_wall_ns, heard.times.t_send_wall_ns,
                                      cdr.bytes()};
    if (std::string problem = writer_.write(message); !problem.empty()) return problem;
  }
  return {};
}

}  // namespace articam::listen
