#include "hal/link/message_encoder.hpp"

#include <pb_encode.h>

#include <algorithm>

#include "hal/wire/articam.nanopb.h"
#include "hal/wire/packet.hpp"

namespace articam::hal {
namespace {

static_assert(articam_wire_Packet_size <= wire::kMaxPayloadSize, "articam.options has outgrown the packet");

template <class List, class T, std::size_t N>
void copy(const List& list, T (&out)[N], pb_size_t& count) noexcept {
  static_assert(List::capacity() == N, "message.hpp and articam.options disagree");
  std::ranges::transform(list, out, [](auto x) { return static_cast<T>(x); });
  count = static_cast<pb_size_t>(list.size());
}

void copy(const wire::Text& text, char (&out)[wire::kMaxName + 1]) noexcept {
  *std::ranges::copy(text, out).out = '\0';
}

Result<std::size_t> encode(const articam_wire_Packet& packet, std::span<std::uint8_t> out) noexcept {
  pb_ostream_t stream = pb_ostream_from_buffer(out.data(), out.size());
  if (!pb_encode(&stream, articam_wire_Packet_fields, &packet)) return Status::bad_argument;
  return std::size_t{stream.bytes_written};
}

}  // namespace

Result<std::size_t> encode_message(const wire::EstimateMessage& m, std::span<std::uint8_t> out) noexcept {
  articam_wire_Packet packet{};
  packet.which_content = articam_wire_Packet_estimate_tag;
  articam_wire_Estimate& to = packet.content.estimate;
  to.schema = m.schema, to.session = m.session, to.model_hash = m.model_hash;
  to.number = m.number, to.frame = m.frame;
  to.t_capture_ns = m.t_capture.ns, to.t_send_ns = m.t_send.ns;
  to.status = static_cast<articam_wire_Status>(m.status);
  to.reason = static_cast<articam_wire_Reason>(m.reason);
  to.valid = m.valid;
  copy(m.t_cam_obj, to.t_cam_obj, to.t_cam_obj_count);
  copy(m.joints, to.joints, to.joints_count);
  copy(m.velocity, to.velocity, to.velocity_count);
  copy(m.covariance, to.covariance, to.covariance_count);
  copy(m.observability, to.observability, to.observability_count);
  to.matched = m.matched, to.rms_px = m.rms_px;
  copy(m.t_base_obj, to.t_base_obj, to.t_base_obj_count);
  return encode(packet, out);
}

Result<std::size_t> encode_message(const wire::ModelMessage& m, std::span<std::uint8_t> out) noexcept {
  articam_wire_Packet packet{};
  packet.which_content = articam_wire_Packet_model_tag;
  articam_wire_Model& to = packet.content.model;
  to.schema = m.schema, to.session = m.session, to.model_hash = m.model_hash;
  copy(m.name, to.name);
  for (const wire::Text& name : m.joint_names) copy(name, to.joint_names[to.joint_names_count++]);
  to.rate_hz = m.rate_hz;
  copy(m.t_base_cam, to.t_base_cam, to.t_base_cam_count);
  copy(m.joint_kinds, to.joint_kinds, to.joint_kinds_count);
  return encode(packet, out);
}

}  // namespace articam::hal
