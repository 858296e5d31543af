#pragma once
/// @file  A tracker that takes detections where the camera lends no pixels, and knows how long its last step took.

#include <chrono>

#include "core/timestamp.hpp"
#include "core/tracker/tracking_status.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"

namespace articam::sim {

/// Stands in for a tracker in a RunLoop. `seen` are the marks of the frame that was lent last, if it has no pixels.
/// A rival, where there is one, takes the same marks; its time is not counted.
/// Steps are measured in real time: they differ from run to run.
template <class Tracker>
class EyeTracker {
 public:
  using EstimateType = typename Tracker::EstimateType;

  EyeTracker(Tracker& tracker, Tracker* rival, const vision::Detections& seen) noexcept
      : tracker_{tracker}, rival_{rival}, seen_{seen} {}

  EstimateType step(const ImageView& image, Timestamp t) noexcept {
    const auto begin = std::chrono::steady_clock::now();
    const EstimateType estimate = image.data == nullptr ? tracker_.step(seen_, {}, t) : tracker_.step(image, t);
    step_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (rival_ != nullptr) rival_estimate_ = rival_->step(tracker_.detections(), tracker_.image_report(), t);
    return estimate;
  }
  EstimateType coast(Timestamp t, tracker::Reason why) noexcept {
    rival_estimate_ = {};
    return tracker_.coast(t, why);
  }

  double step_s() const noexcept { return step_s_; }
  const EstimateType& rival_estimate() const noexcept { return rival_estimate_; }  ///< not valid where there is none

 private:
  Tracker& tracker_;
  Tracker* rival_;
  const vision::Detections& seen_;
  double step_s_{};
  EstimateType rival_estimate_{};
};

}  // namespace articam::sim
