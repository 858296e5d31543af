#pragma once
/// @file  An estimate as it was heard, and what takes it.

#include <cstdint>
#include <string>

#include "core/timestamp.hpp"
#include "hal/wire/message.hpp"

namespace articam::listen {

/// Those ending in wall_ns are on the host's clock, ns since 1970. The board's are mapped there by ClockMap, so that
/// t_send_wall_ns is never later than the receipt.
struct Times {
  std::int64_t receipt_wall_ns{};
  std::int64_t t_send_wall_ns{};
  std::int64_t t_capture_wall_ns{};
  double age_s{};       ///< from capture to receipt
  bool age_is_exact{};  ///< board and host are one machine; otherwise the quickest packet's way is left out
};

struct Heard {
  const wire::EstimateMessage& estimate;
  const wire::ModelMessage& model;  ///< of the same session, with as many joint names as a valid estimate has joints
  Timestamp t_first{};              ///< capture of the session's first estimate that was heard
  Times times{};
};

class Output {
 public:
  virtual ~Output() = default;

  /// Both: empty, or a sentence that says why this output has failed. It is not asked again then.
  virtual std::string take(const Heard& heard) = 0;
  virtual std::string finish() { return {}; }
};

}  // namespace articam::listen
