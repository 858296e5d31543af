#include "host_sim/report/pull_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace articam::sim {
namespace {

TEST(PullMetrics, AreThoseOfADecayThatIsKnown) {
  // 100 mm at 1 s, with a time constant of 0.5 s: within 1 mm after ln(100) / 2 s.
  std::vector<ControlSample> samples;
  for (int i = 0; i < 1600; ++i) {
    ControlSample sample;
    sample.t_s = 0.005 * i;
    sample.target = sample.t_s < 1 ? 0 : 0.1;
    sample.position = sample.t_s < 1 ? 0 : 0.1 * (1 - std::exp(-2 * (sample.t_s - 1)));
    sample.told = sample.position + 0.0005;
    samples.push_back(sample);
  }
  const std::vector<JointCommand> commands{{0.5, 0}, {1, 0.1}};
  const PullMetrics metrics = evaluate_pull(samples, commands, 0.001, 0.005);
  EXPECT_EQ(metrics.commands, 1);
  EXPECT_EQ(metrics.settled, 1);
  EXPECT_NEAR(metrics.settling_s, std::log(100.0) / 2, 0.006) << "to a sample";
  EXPECT_EQ(metrics.overshoot, 0);
  EXPECT_NEAR(metrics.told_rms, 0.5, 1e-9);
  EXPECT_NEAR(metrics.error_peak, 100 * std::exp(-2 * kAtRest_s), 0.01);
  EXPECT_EQ(metrics.jerk_rms, 0);
}

TEST(PullMetrics, OvershootIsWhatLiesBeyondTheTargetAndNotBeforeIt) {
  std::vector<ControlSample> samples;
  for (int i = 0; i < 400; ++i) {
    ControlSample sample;
    sample.t_s = 0.005 * i;
    sample.position = i > 300 ? 0.098 : 0.1;
    samples.push_back(sample);
  }
  const std::vector<JointCommand> closing{{0, 0.2}, {0.5, 0.1}}, opening{{0, 0}, {0.5, 0.1}};
  EXPECT_NEAR(evaluate_pull(samples, closing, 0.01, 0.005).overshoot, 2, 1e-9);
  EXPECT_NEAR(evaluate_pull(samples, opening, 0.01, 0.005).overshoot, 0, 1e-9);
}

TEST(PullMetrics, OfNothingAreNothing) { EXPECT_EQ(evaluate_pull({}, {}, 1, 1).commands, 0); }

}  // namespace
}  // namespace articam::sim
