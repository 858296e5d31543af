#include "tools/listen/decode.hpp"

#include "hal/wire/message_reader.hpp"
#include "hal/wire/packet.hpp"

// After all others: it declares articam::wire::Status, where our headers mean articam::Status.
#include "hal/wire/articam.pb.h"

namespace articam::listen {

using wire::Fault;

struct Decoder::Protobuf {
  wire::Packet packet;
  wire::Message judged;
};

namespace {

static_assert(wire::Status_MAX == static_cast<int>(tracker::TrackingStatus::fault));
static_assert(wire::Reason_MAX == static_cast<int>(tracker::Reason::blurred));
static_assert(wire::Observability_MAX == static_cast<int>(tracker::Observability::observed));
static_assert(wire::JointKind_MAX == static_cast<int>(model::JointKind::prismatic));

/// False when there are more than the capacity of articam.options: no board sends that.
template <class From, class T, std::size_t N>
bool fill(const From& from, FixedVector<T, N>& to) {
  to.clear();
  for (const auto x : from) {
    if (!to.push_back(static_cast<T>(x))) return false;
  }
  return true;
}

bool fill_names(const google::protobuf::RepeatedPtrField<std::string>& from,
                decltype(wire::ModelMessage::joint_names)& to) {
  to.clear();
  wire::Text name;
  for (const std::string& text : from) {
    if (!fill(text, name) || !to.push_back(name)) return false;
  }
  return true;
}

Fault convert(const wire::Estimate& in, wire::EstimateMessage& out) {
  out.schema = in.schema(), out.session = in.session(), out.model_hash = in.model_hash();
  out.number = in.number(), out.frame = in.frame();
  out.t_capture = {in.t_capture_ns()}, out.t_send = {in.t_send_ns()};
  out.status = static_cast<tracker::TrackingStatus>(in.status());
  out.reason = static_cast<tracker::Reason>(in.reason());
  out.valid = in.valid(), out.matched = in.matched(), out.rms_px = in.rms_px();
  const bool fits = fill(in.t_cam_obj(), out.t_cam_obj) && fill(in.joints(), out.joints) &&
                    fill(in.velocity(), out.velocity) && fill(in.covariance(), out.covariance) &&
                    fill(in.observability(), out.observability) && fill(in.t_base_obj(), out.t_base_obj);
  return fits ? wire::check(out) : Fault::malformed;
}

Fault convert(const wire::Model& in, wire::ModelMessage& out) {
  out.schema = in.schema(), out.session = in.session(), out.model_hash = in.model_hash(), out.rate_hz = in.rate_hz();
  const bool fits = fill(in.name(), out.name) && fill_names(in.joint_names(), out.joint_names) &&
                    fill(in.t_base_cam(), out.t_base_cam) && fill(in.joint_kinds(), out.joint_kinds);
  return fits ? wire::check(out) : Fault::malformed;
}

}  // namespace

Decoder::Decoder(wire::Verifier* verifier) : verifier_{verifier}, protobuf_{std::make_unique<Protobuf>()} {}
Decoder::~Decoder() = default;

Fault Decoder::decode(std::span<const std::uint8_t> packet, wire::Message& out) {
  wire::PacketView view;
  if (const Fault fault = wire::open_packet(packet, view); fault != Fault::none) return fault;
  if (const Fault fault = wire::authenticate(view, verifier_); fault != Fault::none) return fault;
  return decode_payload(view.payload, out);
}

Fault Decoder::decode_payload(std::span<const std::uint8_t> payload, wire::Message& out) {
  // Protobuf cuts a number that is too large for its field and merges what came twice, without a word. So the reader of
  // hal/wire is the judge, at this end as at the controller's; protobuf has the second word, and reads the fields.
  const Fault fault = wire::parse_message(payload, protobuf_->judged);
  out.kind = protobuf_->judged.kind;
  if (fault != Fault::none) return fault;
  wire::Packet& packet = protobuf_->packet;
  if (!packet.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) return Fault::malformed;
  switch (packet.content_case()) {
    case wire::Packet::kEstimate:
      return convert(packet.estimate(), out.estimate);
    case wire::Packet::kModel:
      return convert(packet.model(), out.model);
    case wire::Packet::CONTENT_NOT_SET:
      break;
  }
  return Fault::malformed;
}

}  // namespace articam::listen
