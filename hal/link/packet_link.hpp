#pragma once
/// @file  The link of the board: every estimate becomes one packet, whatever carries it.

#include <array>
#include <concepts>
#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "hal/link/message_encoder.hpp"
#include "hal/link/to_message.hpp"
#include "hal/ports/clock_port.hpp"
#include "hal/ports/link_port.hpp"
#include "hal/wire/message_reader.hpp"
#include "hal/wire/packet.hpp"

namespace articam::hal {

///   send  one whole packet, or nothing of it; never waits. io_error means that it did not go out.
template <class T>
concept Transport = requires(T transport, std::span<const std::uint8_t> packet) {
  { transport.send(packet) }
  noexcept->std::same_as<Status>;
};

namespace detail {

/// What is left of an estimate that no receiver would take: that this turn of the loop has none, and why.
inline void take_numbers_out(wire::EstimateMessage& m) noexcept {
  m.valid = false;
  m.status = tracker::TrackingStatus::fault, m.reason = tracker::Reason::large_residual;
  m.t_cam_obj.clear(), m.joints.clear(), m.velocity.clear(), m.covariance.clear(), m.t_base_obj.clear();
  m.matched = 0, m.rms_px = 0;
}

}  // namespace detail

/// Once a second a packet with the names of the model goes before the estimate.
template <class Estimate, Transport Carrier, ClockPort Clock>
class PacketLink;

template <class Model, class S, Transport Carrier, ClockPort Clock>
class PacketLink<tracker::Estimate<Model, S>, Carrier, Clock> {
 public:
  /// `session`: draw_session(). `signer`: null, or whoever authenticates the packets. Carrier, clock and signer are the
  /// caller's and outlive the link.
  PacketLink(Carrier& carrier, const Clock& clock, const ToMessage<Model>& to_message,
             wire::Signer* signer = nullptr) noexcept
      : carrier_{carrier}, clock_{clock}, to_message_{to_message}, signer_{signer} {}

  /// Allocates nothing and never waits.
  /// Errors  io_error: it did not go out; bad_argument: it is not consistent, such as a number that is not finite, and
  /// no receiver would take it. In its place goes that there is none, as a fault: each turn of the loop is heard of.
  Status publish(const tracker::Estimate<Model, S>& estimate) noexcept {
    const Timestamp now = clock_.now();
    if (sent_ == 0 || seconds_between(t_model_, now) >= 1) {
      t_model_ = now;
      static_cast<void>(send(to_message_.model()));  // the next second brings another
    }
    wire::EstimateMessage message = to_message_.estimate(estimate);
    message.number = sent_++;
    message.t_send = clock_.now();
    if (wire::check(message) == wire::Fault::none) return send(message);
    detail::take_numbers_out(message);
    const Status status = send(message);
    return status == Status::ok ? Status::bad_argument : status;
  }

 private:
  template <class Message>
  Status send(const Message& message) noexcept {
    const std::span<std::uint8_t> packet{packet_};
    const auto payload = encode_message(message, packet.subspan(wire::kHeaderSize, wire::kMaxPayloadSize));
    if (!payload.ok()) return payload.status();
    const auto size = wire::seal_packet(packet, payload.value(), signer_);
    return size.ok() ? carrier_.send(packet.first(size.value())) : size.status();
  }

  Carrier& carrier_;
  const Clock& clock_;
  ToMessage<Model> to_message_;
  wire::Signer* signer_;
  std::uint32_t sent_{};
  Timestamp t_model_{};
  std::array<std::uint8_t, wire::kMaxPacketSize> packet_{};
};

}  // namespace articam::hal
