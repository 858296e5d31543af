#pragma once
/// @file  Messages of the link, made up, and translated by the protobuf library. Needs the target wire_by_protobuf.

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hal/wire/message.hpp"
#include "hal/wire/packet.hpp"
#include "tests/support/random_state.hpp"

// After the others, whose Status it hides.
#include "hal/wire/articam.pb.h"

namespace articam::test {

using Bytes = std::vector<std::uint8_t>;

template <std::size_t N>
void fill(FixedVector<double, N>& list, std::size_t size, Random& random) {
  list.clear();
  for (std::size_t i = 0; i < size; ++i) (void)list.push_back(random.uniform(-2, 2));
}

inline void fill_pose(wire::PoseNumbers& pose, Random& random) {
  fill(pose, 7, random);
  const double norm = std::hypot(std::hypot(pose[3], pose[4]), std::hypot(pose[5], pose[6]));
  for (std::size_t i = 3; i < 7; ++i) pose[i] /= norm;
}

/// Valid, with so many joints; every field differs from message to message.
inline wire::EstimateMessage random_estimate(Random& random, std::size_t num_joints = 2) {
  const auto whole = [&](double largest) { return static_cast<std::uint32_t>(random.uniform(0, largest)); };
  wire::EstimateMessage m;
  m.session = whole(4e9), m.model_hash = whole(4e9), m.number = whole(4e9), m.frame = whole(4e9);
  m.t_capture.ns = whole(4e9), m.t_send.ns = m.t_capture.ns + whole(1e8);
  m.status = static_cast<tracker::TrackingStatus>(whole(6)), m.reason = static_cast<tracker::Reason>(whole(14));
  m.valid = true;
  fill_pose(m.t_cam_obj, random);
  fill(m.joints, num_joints, random);
  fill(m.velocity, 6 + num_joints, random);
  fill(m.covariance, wire::triangle_size(6 + num_joints), random);
  for (double& x : m.covariance) x = std::abs(x);  // variances are among them
  for (std::size_t i = 0; i < 6 + num_joints; ++i) {
    (void)m.observability.push_back(static_cast<tracker::Observability>(whole(3)));
  }
  m.matched = whole(64), m.rms_px = random.uniform(0, 2);
  if (whole(2) == 1) fill_pose(m.t_base_obj, random);
  return m;
}

inline wire::Text text_of(std::string_view text) {
  wire::Text out;
  for (const char c : text) (void)out.push_back(c);
  return out;
}

inline wire::ModelMessage random_model(Random& random, std::size_t num_joints = 2) {
  wire::ModelMessage m;
  m.session = static_cast<std::uint64_t>(random.uniform(0, 1e18)), m.model_hash = 7;
  m.name = text_of("cabinet");
  for (std::size_t i = 0; i < num_joints; ++i) {
    (void)m.joint_names.push_back(text_of("joint_" + std::to_string(i)));
    (void)m.joint_kinds.push_back(static_cast<model::JointKind>(random.uniform(0, 3)));
  }
  m.rate_hz = random.uniform(1, 120);
  if (random.uniform(0, 1) < 0.5) fill_pose(m.t_base_cam, random);
  return m;
}

/// Both as the protobuf library writes them: equal bytes are equal messages, to the last bit of every number.
inline std::string by_protobuf(const wire::EstimateMessage& m) {
  wire::Packet packet;
  wire::Estimate& out = *packet.mutable_estimate();
  out.set_schema(m.schema), out.set_session(m.session), out.set_model_hash(m.model_hash);
  out.set_number(m.number), out.set_frame(m.frame);
  out.set_t_capture_ns(m.t_capture.ns), out.set_t_send_ns(m.t_send.ns);
  out.set_status(static_cast<wire::Status>(m.status)), out.set_reason(static_cast<wire::Reason>(m.reason));
  out.set_valid(m.valid);
  for (const double x : m.t_cam_obj) out.add_t_cam_obj(x);
  for (const double x : m.joints) out.add_joints(x);
  for (const double x : m.velocity) out.add_velocity(x);
  for (const double x : m.covariance) out.add_covariance(x);
  for (const auto x : m.observability) out.add_observability(static_cast<wire::Observability>(x));
  out.set_matched(m.matched), out.set_rms_px(m.rms_px);
  for (const double x : m.t_base_obj) out.add_t_base_obj(x);
  return packet.SerializeAsString();
}

inline std::string by_protobuf(const wire::ModelMessage& m) {
  wire::Packet packet;
  wire::Model& out = *packet.mutable_model();
  out.set_schema(m.schema), out.set_session(m.session), out.set_model_hash(m.model_hash);
  out.set_name(std::string{wire::view(m.name)});
  for (const wire::Text& name : m.joint_names) out.add_joint_names(std::string{wire::view(name)});
  out.set_rate_hz(m.rate_hz);
  for (const double x : m.t_base_cam) out.add_t_base_cam(x);
  for (const auto x : m.joint_kinds) out.add_joint_kinds(static_cast<wire::JointKind>(x));
  return packet.SerializeAsString();
}

inline std::string by_protobuf(const wire::Message& m) {
  return m.kind == wire::MessageKind::estimate ? by_protobuf(m.estimate) : by_protobuf(m.model);
}

inline std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The packet around a payload.
inline Bytes sealed(const std::string& payload, wire::Signer* signer = nullptr) {
  Bytes packet(wire::kMaxPacketSize);
  std::ranges::copy(payload, packet.begin() + wire::kHeaderSize);
  const auto size = wire::seal_packet(packet, payload.size(), signer);
  packet.resize(size.ok() ? size.value() : 0);
  return packet;
}

template <class Message>
Bytes packet_of(const Message& message, wire::Signer* signer = nullptr) {
  return sealed(by_protobuf(message), signer);
}

}  // namespace articam::test
