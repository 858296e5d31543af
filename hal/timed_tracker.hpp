#pragma once
/// @file  A tracker that knows how long its last step took.

#include "core/timestamp.hpp"
#include "core/tracker/tracking_status.hpp"
#include "core/vision/image_view.hpp"
#include "hal/ports/clock_port.hpp"

namespace articam::hal {

/// Stands in for a tracker in a RunLoop. The clock may be another one than the loop's: a simulation measures its steps
/// in real time.
template <class Tracker, ClockPort Clock>
class TimedTracker {
 public:
  using EstimateType = typename Tracker::EstimateType;

  TimedTracker(Tracker& tracker, const Clock& clock) noexcept : tracker_{tracker}, clock_{clock} {}

  EstimateType step(const ImageView& image, Timestamp t) noexcept {
    const Timestamp begin = clock_.now();
    const EstimateType estimate = tracker_.step(image, t);
    step_s_ = seconds_between(begin, clock_.now());
    return estimate;
  }
  EstimateType coast(Timestamp t, tracker::Reason why) noexcept { return tracker_.coast(t, why); }

  double step_s() const noexcept { return step_s_; }

 private:
  Tracker& tracker_;
  const Clock& clock_;
  double step_s_{};
};

}  // namespace articam::hal
