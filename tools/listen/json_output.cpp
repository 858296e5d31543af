#include "tools/listen/json_output.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "tools/listen/covariance.hpp"

namespace articam::listen {
namespace {

using Json = nlohmann::ordered_json;

Json pose(const wire::PoseNumbers& T) {
  constexpr std::string_view kNames[]{"px", "py", "pz", "qw", "qx", "qy", "qz"};
  Json json;
  for (std::size_t i = 0; i < T.size(); ++i) json[std::string{kNames[i]}] = T[i];
  return json;
}

void add_numbers(Json& json, const Heard& heard) {
  const wire::EstimateMessage& e = heard.estimate;
  constexpr const char* kNames[]{"px", "py", "pz", "rx", "ry", "rz"};
  for (std::size_t i = 0; i < dof(e); ++i) {
    const bool is_joint = i >= 6;
    const std::string name{is_joint ? wire::view(heard.model.joint_names[i - 6]) : kNames[i]};
    if (is_joint) json["joints"][name] = e.joints[i - 6];
    if (is_joint && !heard.model.joint_kinds.empty()) json["units"][name] = wire::unit(heard.model, i - 6);
    json["velocity"][name] = e.velocity[i];
    json["std"][name] = deviation(e, i);
  }
  json["t_cam_obj"] = pose(e.t_cam_obj);
  if (!e.t_base_obj.empty()) json["t_base_obj"] = pose(e.t_base_obj);
}

}  // namespace

std::string to_json(const Heard& heard) {
  const wire::EstimateMessage& e = heard.estimate;
  Json json;
  json["timestamp"] = static_cast<double>(heard.times.t_capture_wall_ns) / 1e9;
  json["model"] = wire::view(heard.model.name);
  json["number"] = e.number;
  json["frame"] = e.frame;
  json["status"] = static_cast<int>(e.status);
  json["status_name"] = name(e.status);
  json["reason"] = static_cast<int>(e.reason);
  json["reason_name"] = name(e.reason);
  json["valid"] = e.valid;
  json["matched"] = e.matched;
  if (e.matched > 0) json["rms_px"] = e.rms_px;
  json["age_s"] = heard.times.age_s;
  if (e.valid) add_numbers(json, heard);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // names are the board's, in whatever encoding
}

JsonOutput::~JsonOutput() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string JsonOutput::open(const wire::Address& address) {
  descriptor_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor_ < 0) return std::string{"JSON over UDP: "} + std::strerror(errno);
  peer_.sin_family = AF_INET;
  peer_.sin_addr.s_addr = std::bit_cast<in_addr_t>(address.host);
  peer_.sin_port = htons(address.port);
  return {};
}

std::string JsonOutput::take(const Heard& heard) {
  const std::string json = to_json(heard);
  static_cast<void>(::sendto(descriptor_, json.data(), json.size(), MSG_NOSIGNAL,
                             reinterpret_cast<const sockaddr*>(&peer_), sizeof peer_));
  return {};
}

}  // namespace articam::listen
