#pragma once
/// @file  Received bytes -> a message of articam.proto, by protobuf's own library, as strict as the controller's
/// reader.

#include <cstdint>
#include <memory>
#include <span>

#include "hal/wire/authentication.hpp"
#include "hal/wire/fault.hpp"
#include "hal/wire/message.hpp"

namespace articam::listen {

/// Decodes packets of hal/wire/packet.hpp. Whatever the bytes are, work and memory are bounded by their number.
class Decoder {
 public:
  /// `verifier`: null, or whoever judges the tags; it outlives the decoder.
  explicit Decoder(wire::Verifier* verifier = nullptr);
  ~Decoder();

  /// none when `out` is a message that may be used without another look; otherwise `out` is half written.
  wire::Fault decode(std::span<const std::uint8_t> packet, wire::Message& out);
  /// The same from the payload alone: takes what wire::read_message takes, and reads the same.
  wire::Fault decode_payload(std::span<const std::uint8_t> payload, wire::Message& out);

 private:
  struct Protobuf;  ///< its header has names that ours have too
  wire::Verifier* verifier_;
  std::unique_ptr<Protobuf> protobuf_;  ///< kept, so that its memory is used again
};

}  // namespace articam::listen
