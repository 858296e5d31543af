#include "host_sim/world/sway.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace articam::sim {
namespace {

TEST(Sway, HasTheSizeThatIsAskedForAndItsOwnDerivative) {
  const SwayOptions options;
  const Sway sway{options, 7};
  double squares = 0, worst = 0;
  constexpr int kSamples = 20000;
  constexpr double kStep_s = 1e-5;
  for (int i = 0; i < kSamples; ++i) {
    const double t_s = 0.05 * i;
    const auto now = sway.at(t_s);
    squares += now.pose.t.x() * now.pose.t.x();
    const Vec<double, 3> rate = (sway.at(t_s + kStep_s).pose.t - sway.at(t_s - kStep_s).pose.t) / (2 * kStep_s);
    worst = std::max(worst, (rate - now.twist.head<3>()).norm());
  }
  // Five sines over 1000 s, the slowest at 0.05 Hz: their squares' means are out by a fiftieth at most.
  EXPECT_NEAR(std::sqrt(squares / kSamples), options.position_m[0], 0.02 * options.position_m[0]);
  EXPECT_LT(worst, 1e-9);
}

TEST(Sway, IsAFunctionOfSeedAndTime) {
  const Sway one{{}, 1}, same{{}, 1}, other{{}, 2};
  EXPECT_EQ(one.at(3.2).pose.t, same.at(3.2).pose.t);
  EXPECT_NE(one.at(3.2).pose.t, other.at(3.2).pose.t);
}

}  // namespace
}  // namespace articam::sim
