#include "host_sim/world/drawer_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace articam::sim {
namespace {

constexpr DrawerMotion kMotion{};

TEST(DrawerMotion, RestsFirst) {
  for (const double t_s : {0.0, 2.5, 5.0}) {
    EXPECT_EQ(kMotion.at(t_s).position, kMotion.closed_m);
    EXPECT_EQ(kMotion.at(t_s).velocity, 0);
  }
}

TEST(DrawerMotion, HasTheVelocityOfItsNumericDerivative) {
  constexpr double kStep_s = 1e-5;
  for (double t_s = 0; t_s < 30; t_s += 0.0137) {
    const double slope = (kMotion.at(t_s + kStep_s).position - kMotion.at(t_s - kStep_s).position) / (2 * kStep_s);
    // The second derivative is bounded and continuous, the third jumps by up to 0.2 m/s^3: error below h^2 of it.
    EXPECT_NEAR(kMotion.at(t_s).velocity, slope, 1e-9) << "t = " << t_s;
  }
}

TEST(DrawerMotion, ReachesButNeverPasses50MillimetresASecond) {
  double fastest = 0;
  for (double t_s = 0; t_s < 30; t_s += 0.001) fastest = std::max(fastest, std::abs(kMotion.at(t_s).velocity));
  EXPECT_LE(fastest, 0.050 + 1e-15);
  EXPECT_GT(fastest, 0.0499);
}

TEST(DrawerMotion, StaysBetweenClosedAndOpenAndRepeats) {
  for (double t_s = kMotion.rest_s; t_s < 30; t_s += 0.01) {
    const double position = kMotion.at(t_s).position;
    EXPECT_GE(position, kMotion.closed_m - 1e-15);
    EXPECT_LE(position, kMotion.open_m + 1e-15);
    EXPECT_NEAR(position, kMotion.at(t_s + 2 * (kMotion.stroke_s + kMotion.dwell_s)).position, 1e-12);
  }
}

}  // namespace
}  // namespace articam::sim
