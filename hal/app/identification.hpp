#pragma once
/// @file  What `--identify` does around a replay, whatever is replayed.

#include <string>
#include <utility>

#include "core/tracker/tracker.hpp"
#include "hal/app/print.hpp"
#include "tools/identify/job.hpp"

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

/// What a replay has seen.
struct Sightings {
  CameraParameters camera{};
  identify::Recording recording;
};

/// Reads the sources, plays, and identifies what was asked for. `play(Sightings&)` returns what went wrong, or nothing,
/// and so does this.
template <class Model, class Play>
std::string identify_from(const identify::JobOptions& options, const Play& play) {
  Sightings sightings;
  if (options.outputs.empty()) return play(sightings);
  modelgen::Diagnostics diagnostics;
  const auto job = identify::Job::prepare(options, identify::Object::of<Model>(), diagnostics);
  if (!job) return "nothing to identify from:\n" + diagnostics.text();
  if (auto problem = play(sightings); !problem.empty()) return problem;
  std::string text;
  auto problem = job->finish(sightings.recording, sightings.camera, text);
  if (auto unprinted = print(text); problem.empty()) problem = std::move(unprinted);
  return problem;
}

}  // namespace articam::app
