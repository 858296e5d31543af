#pragma once
/// @file  From the time stamp of a frame to the middle of its exposure.

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "core/timestamp.hpp"

namespace articam::hal {

/// What of a frame the time stamp marks; a row is read out at the end of its exposure.
enum class StampMarks : std::uint8_t { exposure_start, readout_start, readout_end };

/// A stamp of the monotonic clock is neither of the future nor older than a frame can be.
constexpr bool is_of_this_clock(Timestamp stamp, Timestamp now, std::chrono::nanoseconds max_age) noexcept {
  return stamp.ns <= now.ns && stamp.ns >= now.ns - max_age.count();
}

/// Mid-exposure of the first row, never of the future: a driver that marks the readout as the start of the exposure
/// would date a long exposure there. `readout` is the time from the first row to the last.
constexpr Timestamp mid_exposure(Timestamp stamp, StampMarks marks, std::chrono::nanoseconds exposure,
                                 std::chrono::nanoseconds readout, Timestamp now) noexcept {
  const std::int64_t half_ns = exposure.count() / 2;
  if (marks == StampMarks::exposure_start) return {std::min(stamp.ns + half_ns, now.ns)};
  return {stamp.ns - half_ns - (marks == StampMarks::readout_end ? readout.count() : 0)};
}

}  // namespace articam::hal
