#pragma once
/// @file  A clock that somebody else winds: a timer interrupt, a simulation.

#include "hal/ports/clock_port.hpp"

namespace articam::hal {

class ManualClock {
 public:
  Timestamp now() const noexcept { return now_; }
  /// An earlier time than the present one is ignored: the port is monotonic.
  void set(Timestamp t) noexcept { now_ = t > now_ ? t : now_; }

 private:
  Timestamp now_{};
};
static_assert(ClockPort<ManualClock>);

}  // namespace articam::hal
