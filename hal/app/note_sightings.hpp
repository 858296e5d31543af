#pragma once
/// @file  A tracker's newest frame as a moment of a recording to identify from.

#include "core/tracker/tracker.hpp"
#include "tools/identify/recording.hpp"

namespace articam::app {

/// Adds the frame of an estimate that can be trusted and has as many equations as unknowns.
template <class Model, class S>
void note_sightings(const tracker::Tracker<Model, S>& tracker, const tracker::Estimate<Model, S>& estimate,
                    identify::Recording& recording) {
  using tracker::TrackingStatus;
  if (estimate.status != TrackingStatus::tracking && estimate.status != TrackingStatus::degraded) return;
  identify::Moment moment{
      {estimate.q.T_cam_obj.R.template cast<double>().normalized(), estimate.q.T_cam_obj.t.template cast<double>()},
      {},
      {},
      {}};
  for (Eigen::Index j = 0; j < model::kNumJoints<Model>; ++j) {
    moment.joints.push_back(static_cast<double>(estimate.q.joints[j]));
    moment.joint_deviations.push_back(std::sqrt(static_cast<double>(estimate.covariance(6 + j, 6 + j))));
  }
  const double floor_px = tracker.options().floor_px;
  for (std::size_t i = 0; i < tracker.matches().size(); ++i) {
    const auto& match = tracker.matches()[i];
    if (!match.matched) continue;
    const vision::Detection& mark = tracker.detections()[static_cast<std::size_t>(match.detection)];
    moment.sightings.push_back({i, match.pixel.template cast<double>(),
                                static_cast<double>(mark.centre_variance_q24) / (1 << 24), floor_px * floor_px});
  }
  if (2 * moment.sightings.size() >= static_cast<std::size_t>(model::kDof<Model>)) recording.push_back(moment);
}

}  // namespace articam::app
