#pragma once
/// @file  Ports that give the answers of a recording again.

#include <chrono>
#include <cstddef>

#include "core/tracker/estimate.hpp"
#include "hal/ports/camera_port.hpp"
#include "hal/ports/clock_port.hpp"
#include "hal/record/recording_file.hpp"

namespace articam::hal {

/// The tick that the loop is in. `acquire` of the camera goes on to the next one.
class Playback {
 public:
  explicit Playback(const Recording& recording) noexcept : recording_{recording} {}

  const RecordedTick* next() noexcept {
    times_ = 0;
    current_ = next_ < recording_.ticks.size() ? &recording_.ticks[next_++] : nullptr;
    return current_;
  }
  const RecordedTick& current() const noexcept { return *current_; }
  Timestamp next_time() noexcept {
    const TickRecord& record = current_->record;
    return {times_ < record.num_times ? record.times_ns[times_++] : record.times_ns.back()};
  }

 private:
  const Recording& recording_;
  std::size_t next_{};
  const RecordedTick* current_{};
  std::size_t times_{};
};

class ReplayedCamera {
 public:
  explicit ReplayedCamera(Playback& playback) noexcept : playback_{playback} {}

  Status start() noexcept { return Status::ok; }
  void stop() noexcept {}
  /// The frames have no pixels: a ReplayedTracker does not look at them.
  Status acquire(Frame& out, std::chrono::milliseconds) noexcept {
    const RecordedTick* const tick = playback_.next();
    if (tick == nullptr) return Status::end_of_stream;
    if (tick->record.camera == Status::ok) out = {{}, {tick->record.t_exposure_ns}, tick->record.sequence};
    return tick->record.camera;
  }
  void release(Frame& frame) noexcept { frame = {}; }

 private:
  Playback& playback_;
};
static_assert(CameraPort<ReplayedCamera>);

class ReplayedClock {
 public:
  explicit ReplayedClock(Playback& playback) noexcept : playback_{playback} {}
  Timestamp now() const noexcept { return playback_.next_time(); }

 private:
  Playback& playback_;
};
static_assert(ClockPort<ReplayedClock>);

/// Stands in for a tracker in a RunLoop: gives the real one the recorded detections.
template <class Tracker>
class ReplayedTracker {
 public:
  using EstimateType = typename Tracker::EstimateType;

  ReplayedTracker(Tracker& tracker, const Playback& playback) noexcept : tracker_{tracker}, playback_{playback} {}

  EstimateType step(const ImageView&, Timestamp t) noexcept {
    const RecordedTick& tick = playback_.current();
    if (tick.record.mismatched != 0) return tracker_.coast(t, tracker::Reason::image_mismatch);
    return tracker_.step(tick.detections, {tick.record.overloaded != 0, tick.record.image_fault}, t);
  }
  EstimateType coast(Timestamp t, tracker::Reason why) const noexcept { return tracker_.coast(t, why); }

 private:
  Tracker& tracker_;
  const Playback& playback_;
};

}  // namespace articam::hal
