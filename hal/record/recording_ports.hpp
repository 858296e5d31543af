#pragma once
/// @file  Ports that tell a recorder what they answer.

#include <chrono>

#include "core/tracker/estimate.hpp"
#include "hal/ports/camera_port.hpp"
#include "hal/ports/clock_port.hpp"
#include "hal/record/recorder.hpp"

namespace articam::hal {

template <CameraPort Camera>
class RecordingCamera {
 public:
  RecordingCamera(Camera& camera, Recorder& recorder) noexcept : camera_{camera}, recorder_{recorder} {}

  Status start() noexcept { return camera_.start(); }
  void stop() noexcept { camera_.stop(); }
  Status acquire(Frame& out, std::chrono::milliseconds wait) noexcept {
    const Status status = camera_.acquire(out, wait);
    recorder_.acquired(status, out);
    return status;
  }
  void release(Frame& frame) noexcept { camera_.release(frame); }

 private:
  Camera& camera_;
  Recorder& recorder_;
};

template <ClockPort Clock>
class RecordingClock {
 public:
  RecordingClock(const Clock& clock, Recorder& recorder) noexcept : clock_{clock}, recorder_{recorder} {}

  Timestamp now() const noexcept {
    const Timestamp now = clock_.now();
    recorder_.answered(now);
    return now;
  }

 private:
  const Clock& clock_;
  Recorder& recorder_;
};

/// Stands in for a tracker in a RunLoop.
template <class Tracker>
class RecordingTracker {
 public:
  using EstimateType = typename Tracker::EstimateType;

  RecordingTracker(Tracker& tracker, Recorder& recorder) noexcept : tracker_{tracker}, recorder_{recorder} {}

  EstimateType step(const ImageView& image, Timestamp t) noexcept {
    const EstimateType estimate = tracker_.step(image, t);
    recorder_.stepped(tracker_.detections(), tracker_.image_report(),
                      estimate.reason == tracker::Reason::image_mismatch);
    return estimate;
  }
  EstimateType coast(Timestamp t, tracker::Reason why) const noexcept { return tracker_.coast(t, why); }

 private:
  Tracker& tracker_;
  Recorder& recorder_;
};

}  // namespace articam::hal
