#include "tools/listen/listener.hpp"

#include <algorithm>
#include <cstddef>

namespace articam::listen {

void Listener::take(const Received& received) {
  ++packets_;
  const wire::Fault fault = take_message(received);
  if (fault != wire::Fault::none) ++statistics_.faults[static_cast<std::size_t>(fault)];
}

wire::Fault Listener::take_message(const Received& received) {
  const wire::Fault fault = decoder_.decode(received.bytes, message_);
  if (fault != wire::Fault::none) return fault;
  if (message_.kind == wire::MessageKind::estimate) return take_estimate(received);
  return session_of(message_.model.session).take(message_.model, deliver_);
}

wire::Fault Listener::take_estimate(const Received& received) {
  const wire::EstimateMessage& estimate = message_.estimate;
  Session& session = session_of(estimate.session);
  const auto times = session.take(estimate, received);
  if (!times) return wire::Fault::none;
  const double made_s = seconds_between(estimate.t_capture, estimate.t_send);
  statistics_.capture_to_send.take(made_s);
  statistics_.send_to_receipt.take(times->age_s - made_s);
  statistics_.exact = statistics_.exact && times->age_is_exact;
  return session.deliver(estimate, *times, deliver_);
}

Session& Listener::session_of(std::uint64_t id) {
  const auto found = sessions_.find(id);
  if (found == sessions_.end()) {
    ++statistics_.sessions;
    if (sessions_.size() == kMaxSessions) {
      const auto silent =
          std::ranges::min_element(sessions_, {}, [](const auto& session) { return session.second.last_packet; });
      forgotten_ += silent->second.session.counts();
      forgotten_unnamed_ += silent->second.session.unnamed();
      sessions_.erase(silent);
    }
  }
  Entry& entry = sessions_[id];
  entry.last_packet = packets_;
  return entry.session;
}

const Statistics& Listener::statistics() {
  statistics_.estimates = forgotten_;
  statistics_.unnamed = forgotten_unnamed_;
  for (const auto& [id, entry] : sessions_) {
    statistics_.estimates += entry.session.counts();
    statistics_.unnamed += entry.session.unnamed();
  }
  return statistics_;
}

}  // namespace articam::listen
