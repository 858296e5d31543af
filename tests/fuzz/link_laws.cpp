#include "tests/fuzz/link_laws.hpp"

#include <algorithm>

#include "hal/wire/byte_order.hpp"
#include "hal/wire/cobs.hpp"
#include "hal/wire/crc32.hpp"
#include "hal/wire/message_reader.hpp"
#include "hal/wire/packet.hpp"
#include "tests/fuzz/odd_message.hpp"
#include "tests/support/wire_messages.hpp"

namespace articam::fuzz {
namespace {

/// What the protobuf library makes of a payload, unknown fields left out.
std::string protobuf_reading(const Bytes& payload) {
  wire::Packet packet;
  if (!packet.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) return "refused";
  packet.DiscardUnknownFields();
  return packet.SerializeAsString();
}

Bytes sealed(const Bytes& payload) { return test::sealed({payload.begin(), payload.end()}); }

/// Everything of an intake but its counters, told by what it does with the packets that may come next.
std::string state_of(receiver::Intake intake, const wire::EstimateMessage& newest) {
  std::string state;
  for (const std::uint32_t step : {0u, 1u, 63u, ~0u}) {
    wire::EstimateMessage next = newest;
    next.number += step;
    state += intake.take(test::packet_of(next), {}) == receiver::Intake::Taken::estimate ? '+' : '-';
  }
  return state;
}

}  // namespace

std::string LinkLaws::try_one() {
  ++tally_.inputs;
  switch (below(5, random_)) {
    case 0:
      return damaged_packet();
    case 1:
      return resealed_packet();
    case 2:
      return judge(mutated_payload());
    case 3:
      return judge(odd_message(random_));
    default:
      return stream();
  }
}

Bytes LinkLaws::valid_payload() {
  const std::size_t num_joints = below(wire::kMaxJoints + 1, random_);
  const std::string text = below(4, random_) == 0 ? test::by_protobuf(test::random_model(random_, num_joints))
                                                  : test::by_protobuf(test::random_estimate(random_, num_joints));
  return {text.begin(), text.end()};
}

Bytes LinkLaws::mutated_payload() {
  const Bytes other = valid_payload();
  Bytes payload = valid_payload();
  mutate(payload, other, random_);
  payload.shrink_to_fit();
  return payload;
}

std::string LinkLaws::damaged_packet() {
  const Bytes whole = sealed(valid_payload());
  Bytes packet = whole;
  if (below(2, random_) == 0) {
    mutate(packet, whole, random_);
  } else {
    // A header of bad will, under a checksum that is right.
    packet[below(wire::kHeaderSize, random_)] ^= static_cast<std::uint8_t>(1 + below(255, random_));
    const auto crc = packet.size() - wire::kChecksumSize;
    wire::store(wire::crc32(std::span{packet}.first(crc)), std::span{packet}.subspan(crc).first<wire::kChecksumSize>());
  }
  wire::PacketView view;
  const wire::Fault fault = wire::open_packet(packet, view);
  ++tally_.faults[static_cast<std::size_t>(fault)];
  return fault == wire::Fault::none && packet != whole ? "a damaged packet was taken as whole" : "";
}

/// The sender of bad will: everything behind the checksum is reached.
std::string LinkLaws::resealed_packet() {
  test::Random known{1};
  wire::EstimateMessage newest = test::random_estimate(known);
  newest.session = 1, newest.number = 100;
  receiver::Intake intake;
  (void)intake.take(test::packet_of(newest), {});
  const std::string before = state_of(intake, newest);

  Bytes payload = mutated_payload();
  payload.resize(std::min(payload.size(), wire::kMaxPayloadSize));
  if (payload.empty()) return {};
  const auto refused = intake.counters().refused();
  (void)intake.take(sealed(payload), {});
  if (intake.counters().refused() > refused && state_of(intake, newest) != before) {
    return "a refused packet has changed the intake";
  }
  return {};
}

std::string LinkLaws::judge(const Bytes& payload) {
  wire::Message message, by_listener;
  const wire::Fault fault = wire::read_message(payload, message);
  ++tally_.faults[static_cast<std::size_t>(fault)];
  tally_.accepted += fault == wire::Fault::none ? 1 : 0;
  if (decoder_.decode_payload(payload, by_listener) != fault) return "the listener judges otherwise than the receiver";
  // A message that is inconsistent was read all the same.
  if (fault != wire::Fault::none && fault != wire::Fault::inconsistent) return {};
  const std::string reading = test::by_protobuf(message);
  if (test::by_protobuf(by_listener) != reading) return "the listener reads another message than the receiver";
  return protobuf_reading(payload) == reading ? "" : "protobuf reads another message";
}

std::string LinkLaws::stream() {
  wire::CobsDecoder<wire::kMaxPacketSize> decoder;
  const Bytes packet = sealed(valid_payload());
  Bytes frame(wire::cobs_frame_size(packet.size()));
  frame.resize(wire::cobs_encode(packet, frame).value());
  Bytes damaged;
  for (std::size_t n = 1 + below(3, random_); n > 0; --n) damaged.insert(damaged.end(), frame.begin(), frame.end());
  mutate(damaged, frame, random_);
  damaged.push_back(0);
  using Event = decltype(decoder)::Event;
  for (const std::uint8_t byte : damaged) {
    if (decoder.take(byte) != Event::frame) continue;
    ++tally_.frames;
    (void)intake_.take(Bytes(decoder.frame().begin(), decoder.frame().end()), {});
  }
  Event last = Event::none;
  for (const std::uint8_t byte : frame) last = decoder.take(byte);
  return last == Event::frame && std::ranges::equal(decoder.frame(), packet) ? "" : "a sound frame was not heard";
}

}  // namespace articam::fuzz
