#include "host_sim/world/fingers.hpp"

#include <gtest/gtest.h>

namespace articam::sim {
namespace {

HandAtHandle offset(double x_m) { return {{x_m, 0, 0}, Vec<double, 3>::Zero(), Vec6::Zero()}; }

TEST(Fingers, DoNothingWithinTheirPlayAndPushBeyondIt) {
  const FingerOptions options;
  Fingers fingers{options};
  const double half_m = 0.5 * options.play_m.x();
  EXPECT_EQ(fingers.force(offset(0.99 * half_m)).norm(), 0);
  EXPECT_NEAR(fingers.force(offset(half_m + 0.001))[0], 0.001 * options.stiffness, 1e-9);
  EXPECT_NEAR(fingers.force(offset(-half_m - 0.001))[0], -0.001 * options.stiffness, 1e-9);
  EXPECT_EQ(fingers.slipped_m().norm(), 0);
}

TEST(Fingers, SlipAtTheirLimitAndHoldElsewhereAfterwards) {
  const FingerOptions options;
  Fingers fingers{options};
  const double limit_m = 0.5 * options.play_m.x() + options.slip_force / options.stiffness;
  EXPECT_NEAR(fingers.force(offset(limit_m + 0.01))[0], options.slip_force, 1e-9);
  EXPECT_NEAR(fingers.slipped_m().x(), 0.01, 1e-12);
  EXPECT_EQ(fingers.force(offset(0.01))[0], 0) << "the middle of the play has moved";
}

TEST(Fingers, NeverPullWhenTheyPart) {
  Fingers fingers{{}};
  HandAtHandle parting = offset(0.0008);
  parting.rate[0] = -1;
  EXPECT_EQ(fingers.force(parting)[0], 0);
}

}  // namespace
}  // namespace articam::sim
