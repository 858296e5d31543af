#include "host_sim/loop/manipulation.hpp"

#include <gtest/gtest.h>

#include "host_sim/report/pull_metrics.hpp"
#include "tests/host_sim/paper_setting.hpp"

namespace articam::sim {
namespace {

const std::vector<JointCommand> kOpenAndClose{{1, 0.02}, {2, 0.10}, {8, 0.04}};

WorldOptions swaying(double by) {
  WorldOptions options;
  for (double& rms : options.sway.position_m) rms *= by;
  for (double& rms : options.sway.rotation_rad) rms *= by;
  return options;
}

TEST(Manipulation, SettlesTheDrawerWhereItIsWantedWhenNobodySways) {
  Manipulation robot{test::paper_setting(), swaying(0), {}, kOpenAndClose, Manipulation::Eye::truth};
  robot.advance_to(8);
  // Play and friction notwithstanding: the hand goes on until the joint is there.
  EXPECT_NEAR(robot.at(8).position, 0.10, 2e-4);
  robot.advance_to(14);
  EXPECT_NEAR(robot.at(14).position, 0.04, 2e-4);
  const PullMetrics metrics = evaluate_pull(robot.samples(), kOpenAndClose, 0.001, 0.005);
  EXPECT_EQ(metrics.settled, 2);
  EXPECT_LT(metrics.overshoot, 0.5);
  EXPECT_EQ(metrics.told_peak, 0);
}

TEST(Manipulation, FollowsThroughTheSway) {
  Manipulation robot{test::paper_setting(), swaying(1), {}, kOpenAndClose, Manipulation::Eye::truth};
  robot.advance_to(14);
  const PullMetrics metrics = evaluate_pull(robot.samples(), kOpenAndClose, 0.004, 0.005);
  EXPECT_EQ(metrics.settled, 2);
  EXPECT_GT(metrics.error_rms, 0.1) << "the robot drags the drawer along as it sways";
}

TEST(Manipulation, IsAFunctionOfItsSeed) {
  std::vector<double> ends;
  for (const std::uint64_t seed : {1U, 1U, 2U}) {
    WorldOptions options = swaying(1);
    options.seed = seed;
    Manipulation robot{test::paper_setting(), options, {}, kOpenAndClose, Manipulation::Eye::truth};
    robot.advance_to(4);
    ends.push_back(robot.at(4).position);
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_NE(ends[0], ends[2]);
}

TEST(Manipulation, DoesTheSameHoweverTimeIsCut) {
  Manipulation whole{test::paper_setting(), {}, {}, kOpenAndClose, Manipulation::Eye::truth};
  Manipulation cut{test::paper_setting(), {}, {}, kOpenAndClose, Manipulation::Eye::truth};
  whole.advance_to(3);
  for (double t_s = 0; t_s < 3; t_s += 0.0137) cut.advance_to(t_s);
  cut.advance_to(3);
  EXPECT_EQ(whole.at(3).position, cut.at(3).position);
  EXPECT_EQ(whole.at(2.5).position, cut.at(2.5).position) << "what was is remembered";
}

TEST(Manipulation, StandsStillWithoutASighting) {
  Manipulation robot{test::paper_setting(), swaying(0), {}, kOpenAndClose, Manipulation::Eye::sightings};
  robot.advance_to(6);
  EXPECT_NEAR(robot.at(6).position, 0.02, 1e-6);
}

}  // namespace
}  // namespace articam::sim
