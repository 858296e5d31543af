#pragma once
/// @file  A made-up run with a known lag, for the tests of the report.

#include <cmath>

#include "host_sim/report/pull_metrics.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim::test {

inline constexpr double kLag_s = 0.040;
inline constexpr double kDecay_per_s = 3;

/// Ten seconds at 30 Hz: joint "slide" swings and is estimated kLag_s late; the error norm decays at kDecay_per_s.
inline RunRecord late_run() {
  RunRecord run;
  run.scenario = "paper";
  run.mode = "default";
  run.rest_s = 5;
  run.degrees_of_freedom = 8;
  run.joint_names = {"slide", "distance"};
  run.joint_is_length = {true, true};
  for (std::uint32_t i = 0; i < 300; ++i) {
    FrameRecord frame;
    frame.frame = i;
    frame.t_s = i / 30.0;
    frame.truth = {{Quat<double>::Identity(), {0.02, 0.08, 0.7}}, {0.05 + 0.02 * std::sin(frame.t_s), 0.12}};
    frame.true_joint_rates = {0.02 * std::cos(frame.t_s), 0};
    frame.status = tracker::TrackingStatus::tracking;
    frame.estimate = frame.truth;
    frame.estimate->joints[0] = 0.05 + 0.02 * std::sin(frame.t_s - kLag_s);
    frame.estimate->T_cam_obj.t.x() += 0.003;
    if (i % 2 == 0) frame.svd = frame.truth;
    frame.error_norm = 0.1 * std::exp(-kDecay_per_s * frame.t_s) + 1e-5;
    frame.step_s = 1e-3;
    run.frames.push_back(frame);
  }
  run.frames[100].estimate.reset();
  run.frames[100].status = tracker::TrackingStatus::lost;
  return run;
}

/// The same without a single estimate.
inline RunRecord blind_run() {
  RunRecord run = late_run();
  for (FrameRecord& frame : run.frames) {
    frame.estimate.reset();
    frame.svd.reset();
    frame.status = tracker::TrackingStatus::lost;
  }
  return run;
}

/// A robot's second, by the default and by the truth; the SVD baseline does not know the joint.
inline std::vector<FeedbackRun> pulls() {
  std::vector<ControlSample> samples;
  for (int i = 0; i < 200; ++i) {
    ControlSample sample;
    sample.t_s = 0.005 * i;
    sample.target = 0.1;
    sample.position = 0.1 * (1 - std::exp(-5 * sample.t_s));
    sample.told = sample.position + 1e-4;
    samples.push_back(sample);
  }
  return {{"default", {}, samples}, {"svd", {}, {}}, {"truth", {}, samples}};
}

}  // namespace articam::sim::test
