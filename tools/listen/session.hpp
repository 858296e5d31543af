#pragma once
/// @file  One run of a board's program, as far as it was heard.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "hal/wire/fault.hpp"
#include "tools/listen/clock_map.hpp"
#include "tools/listen/output.hpp"
#include "tools/listen/sequence.hpp"
#include "tools/listen/source.hpp"

namespace articam::listen {

/// Keeps estimates back until the names of their joints have come, which the board sends once a second. Then gives
/// them on in the order of receipt, once each.
class Session {
 public:
  static constexpr std::size_t kMaxWaiting = 1024;  ///< estimates, 8 s at 120 Hz; then the oldest are dropped

  using Deliver = std::function<void(const Heard&)>;

  /// Nothing for a duplicate.
  std::optional<Times> take(const wire::EstimateMessage& estimate, const Received& received);
  /// wrong_model or inconsistent when one of both contradicts the other.
  wire::Fault deliver(const wire::EstimateMessage& estimate, const Times& times, const Deliver& to);
  wire::Fault take(const wire::ModelMessage& model, const Deliver& to);

  Counts counts() const { return sequence_.counts(); }
  std::uint64_t unnamed() const { return dropped_ + waiting_.size(); }

 private:
  struct Waiting {
    wire::EstimateMessage estimate;
    Times times;
  };

  Sequence sequence_;
  ClockMap to_wall_, to_monotonic_;
  Timestamp t_first_{};
  std::optional<wire::ModelMessage> model_;
  std::deque<Waiting> waiting_;
  std::uint64_t dropped_{};
};

}  // namespace articam::listen
