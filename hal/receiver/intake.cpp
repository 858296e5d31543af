#include "hal/receiver/intake.hpp"

#include <algorithm>

#include "hal/wire/message_reader.hpp"
#include "hal/wire/packet.hpp"

namespace articam::receiver {
namespace {

/// A packet of the session before the present one is a late one for so long; after it, the board that sends it is the
/// one that is alive.
constexpr double kSilence_s = 1;

}  // namespace

wire::Fault Intake::open(std::span<const std::uint8_t> packet) noexcept {
  using wire::Fault;
  wire::PacketView view;
  if (const Fault fault = wire::open_packet(packet, view); fault != Fault::none) return fault;
  if (const Fault fault = wire::authenticate(view, verifier_); fault != Fault::none) return fault;
  if (const Fault fault = wire::read_message(view.payload, message_); fault != Fault::none) return fault;
  const bool is_estimate = message_.kind == wire::MessageKind::estimate;
  const std::uint64_t hash = is_estimate ? message_.estimate.model_hash : message_.model.model_hash;
  return model_hash_ == 0 || hash == model_hash_ ? Fault::none : Fault::wrong_model;
}

Intake::Taken Intake::take(std::span<const std::uint8_t> packet, Timestamp t_receipt) noexcept {
  ++counters_.packets;
  const wire::Fault fault = open(packet);
  if (fault != wire::Fault::none) {
    ++counters_.faults[static_cast<std::size_t>(fault)];
    return Taken::nothing;
  }
  if (message_.kind == wire::MessageKind::model) {
    ++counters_.models;
    return !any_ || message_.model.session == session_ ? Taken::model : Taken::nothing;
  }
  if (!is_newest(message_.estimate, t_receipt)) return Taken::nothing;
  ++counters_.estimates;
  return Taken::estimate;
}

void Intake::begin_session(const wire::EstimateMessage& estimate) noexcept {
  session_before_ = any_ ? session_ : estimate.session;
  any_ = true;
  session_ = estimate.session;
  newest_ = estimate.number;
  came_ = ~std::uint64_t{0};  // what went before the first packet is not missed
  ++counters_.sessions;
}

bool Intake::is_newest(const wire::EstimateMessage& estimate, Timestamp t_receipt) noexcept {
  if (!any_ || estimate.session != session_) {
    if (any_ && estimate.session == session_before_ && seconds_between(t_heard_, t_receipt) < kSilence_s) {
      ++counters_.reordered;
      return false;
    }
    begin_session(estimate);
    t_heard_ = t_receipt;
    return true;
  }
  t_heard_ = t_receipt;
  const auto ahead = static_cast<std::int32_t>(estimate.number - newest_);  // the number may wrap round
  if (ahead > 0) {
    counters_.lost += static_cast<std::uint64_t>(ahead) - 1;
    came_ = ahead < 64 ? came_ << ahead | 1u : 1u;
    newest_ = estimate.number;
    return true;
  }
  const auto behind = static_cast<std::uint32_t>(newest_ - estimate.number);
  const std::uint64_t place = behind < 64 ? std::uint64_t{1} << behind : 0;
  if ((came_ & place) != 0) {
    ++counters_.duplicated;
    return false;
  }
  ++counters_.reordered;
  if (place != 0) --counters_.lost;  // only late
  came_ |= place;
  return false;
}

}  // namespace articam::receiver
