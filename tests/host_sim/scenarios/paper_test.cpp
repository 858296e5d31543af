#include "host_sim/scenarios/paper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "hal/firmware.hpp"
#include "hal/run_loop.hpp"
#include "host_sim/ports/recording_link.hpp"
#include "host_sim/ports/sim_camera.hpp"
#include "host_sim/report/metrics.hpp"

namespace articam::sim {
namespace {

using Model = PaperScenario::Model;
using Tracker = tracker::Tracker<Model, double>;

RunRecord run(tracker::Mode mode, std::uint32_t num_frames) {
  Renderer renderer{PaperScenario::camera(), {}};
  SimClock clock;
  SimCamera camera{renderer,
                   [](double t_s) { return scene_markers<Model>(PaperScenario::at(t_s).q); },
                   clock,
                   {.num_frames = num_frames}};
  tracker::Options options;
  options.mode = mode;
  const auto tracker = std::make_unique<Tracker>(PaperScenario::camera(), options);
  RunRecord record;
  record.rest_s = PaperScenario::kRest_s;
  record.joint_names = {"drawer_slide", "marker_distance"};
  record.joint_is_length = {true, true};
  RecordingLink<Tracker> link{*tracker, &PaperScenario::at, record};
  hal::RunLoop loop{camera, clock, link, *tracker, {.period = std::chrono::milliseconds{33}}};
  EXPECT_EQ(loop.start(), Status::ok);
  while (loop.run_once() != hal::Tick::ended) {
  }
  return record;
}

TEST(PaperScenario, HasTheVelocityOfItsNumericDerivative) {
  constexpr double kStep_s = 1e-5;
  for (double t_s = 4; t_s < 12; t_s += 0.05) {
    const auto step = model::difference(PaperScenario::at(t_s - kStep_s).q, PaperScenario::at(t_s + kStep_s).q);
    EXPECT_LT((step / (2 * kStep_s) - PaperScenario::at(t_s).qdot).norm(), 1e-9) << "t = " << t_s;
  }
}

// Twelve seconds at 30 Hz: five at rest, then the drawer opens and begins to close.
constexpr std::uint32_t kTwelveSeconds = 360;

/// RMS of the drawer's error while it moves, m; counts the frames that it is made of.
double rms_while_moving_m(const RunRecord& record, int& frames) {
  double squares = 0;
  frames = 0;
  for (const FrameRecord& frame : record.frames) {
    if (frame.true_joint_rates[0] == 0 || !frame.estimate) continue;
    const double error = frame.estimate->joints[0] - frame.truth.joints[0];
    squares += error * error;
    ++frames;
  }
  return std::sqrt(squares / frames);
}

TEST(PaperScenario, IsTrackedWithoutLagWhileTheDrawerMoves) {
  const RunRecord record = run(tracker::Mode::standard, kTwelveSeconds);
  int frames = 0;
  const double rms_m = rms_while_moving_m(record, frames);
  RecordProperty("rms_while_moving_mm", std::to_string(1000 * rms_m));
  EXPECT_GT(frames, 150) << "the drawer moves from 5 s on";
  EXPECT_LT(rms_m, 1e-4);  // asked are 0.5 mm; the marks' noise of some hundredths of a pixel makes 0.02 mm
  const Metrics metrics = evaluate(record);
  EXPECT_EQ(metrics.evaluated, 330);
  EXPECT_LT(metrics.joints[1].rms, 0.5);
  ASSERT_TRUE(metrics.joints[0].lag_ms);
  EXPECT_GT(metrics.joints[0].lag_ms->low, -1);
  EXPECT_LT(metrics.joints[0].lag_ms->high, 1);
}

TEST(PaperScenario, ConvergesBetweenItsTwoGainsAndLagsInThePapersMode) {
  const Metrics metrics = evaluate(run(tracker::Mode::paper, kTwelveSeconds));
  ASSERT_TRUE(metrics.decay_rate_per_s);
  EXPECT_GT(metrics.decay_rate_per_s->value, tracker::GainProfile{}.at_infinity);
  EXPECT_LT(metrics.decay_rate_per_s->value, tracker::GainProfile{}.at_zero);
  ASSERT_TRUE(metrics.joints[0].lag_ms);
  EXPECT_GT(metrics.joints[0].lag_ms->value, 50);  // one step a frame and no velocity: about 1 / gain, 200 ms
}

TEST(PaperScenario, GivesTheSameEstimatesTwice) {
  const RunRecord one = run(tracker::Mode::standard, 20), two = run(tracker::Mode::standard, 20);
  for (std::size_t i = 0; i < one.frames.size(); ++i) {
    ASSERT_TRUE(one.frames[i].estimate && two.frames[i].estimate);
    EXPECT_EQ(one.frames[i].estimate->joints, two.frames[i].estimate->joints);
    EXPECT_EQ(one.frames[i].estimate->T_cam_obj.t, two.frames[i].estimate->T_cam_obj.t);
  }
}

}  // namespace
}  // namespace articam::sim
