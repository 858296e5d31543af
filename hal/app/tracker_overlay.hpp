#pragma once
/// @file  What a tracker saw, expected, matched and rejected in its newest frame, for a picture.

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "core/tracker/tracker.hpp"
#include "hal/replay/overlay.hpp"

namespace articam::app {

/// Why no mark belongs to a feature, beside the nearest one of its kind. The tracker judged by its prediction, this
/// looks back from the estimate: of a frame that moved the estimate far, the numbers are not those of the decision.
template <class S>
std::string why_unmatched(const tracker::Feature<S>& feature, const vision::Detections& marks) {
  const vision::Detection* nearest = nullptr;
  S distance{};
  for (const vision::Detection& mark : marks) {
    const Vec<S, 2> centre{S(vision::from_q16(mark.outer.u_q16)), S(vision::from_q16(mark.outer.v_q16))};
    const S d = (centre - feature.pixel).norm();
    if (mark.kind != feature.kind || (nearest != nullptr && d >= distance)) continue;
    nearest = &mark;
    distance = d;
  }
  if (nearest == nullptr) return "none of its kind seen";
  const auto found = tracker::innovation(feature, *nearest);
  if (found.passes()) return "not paired";
  if (found.centre > found.size) return fmt::format("gate, nearest {:.0f} px off", distance);
  const S size = tracker::mean_radius_px<S>(nearest->outer) / tracker::mean_radius_px<S>(feature.image);
  return fmt::format("size, seen {:.2f} of it", size);
}

template <class Model, class S>
hal::Overlay overlay_of(const tracker::Tracker<Model, S>& tracker, const tracker::Estimate<Model, S>& estimate) {
  const vision::Detections& marks = tracker.detections();
  hal::Overlay overlay;
  for (const vision::Detection& mark : marks) overlay.seen.push_back({mark, "no marker"});
  const auto features = tracker::predict_features<Model, S>(estimate.q, tracker.camera());
  for (std::size_t i = 0; i < features.size(); ++i) {
    const tracker::Match<S>& match = tracker.matches()[i];
    const bool paired = match.detection >= 0 && static_cast<std::size_t>(match.detection) < marks.size();
    const bool outlier = paired && !match.matched;  // the pair was made, then blamed
    if (paired) overlay.seen[static_cast<std::size_t>(match.detection)].note = outlier ? "outlier" : "";
    if (!features[i].visible) continue;
    const std::string why_not = match.matched ? ""
                                : outlier     ? std::string("outlier")
                                              : why_unmatched(features[i], marks);
    overlay.predicted.push_back({std::string(Model::kMarkers[i].name), features[i].image, match.matched, why_not});
  }
  overlay.caption = fmt::format(
      "frame {}   {} {}   matched {}   rms {:.2f} px{}", estimate.frame, name(estimate.status), name(estimate.reason),
      estimate.matched, static_cast<double>(estimate.rms_px), tracker.image_report().overloaded ? "   overloaded" : "");
  return overlay;
}

}  // namespace articam::app
