#pragma once
/// @file  The kernel's monotonic clock.

#include <time.h>

#include "hal/ports/clock_port.hpp"

namespace articam::hal {

/// CLOCK_MONOTONIC: the clock of V4L2 and libcamera time stamps; it never jumps with wall time.
class MonotonicClock {
 public:
  Timestamp now() const noexcept {
    timespec t{};
    ::clock_gettime(CLOCK_MONOTONIC, &t);  // cannot fail for this clock
    return {static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec};
  }
};
static_assert(ClockPort<MonotonicClock>);

}  // namespace articam::hal
