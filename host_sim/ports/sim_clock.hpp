#pragma once
/// @file  Simulated time: it stands still until the camera moves it. Nothing sleeps.

#include "core/timestamp.hpp"
#include "hal/ports/clock_port.hpp"

namespace articam::sim {

class SimClock {
 public:
  Timestamp now() const noexcept { return now_; }
  /// An earlier time than now is ignored: the clock is monotonic.
  void advance_to(Timestamp t) noexcept { now_ = t > now_ ? t : now_; }

 private:
  Timestamp now_{};
};
static_assert(hal::ClockPort<SimClock>);

}  // namespace articam::sim
