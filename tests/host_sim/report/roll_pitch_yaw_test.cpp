#include "host_sim/report/roll_pitch_yaw.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/so3.hpp"

namespace articam::sim {
namespace {

Quat<double> turned(double roll, double pitch, double yaw) {
  return math::exp_so3<double>({0, 0, yaw}) * math::exp_so3<double>({0, pitch, 0}) *
         math::exp_so3<double>({roll, 0, 0});
}

TEST(RollPitchYaw, UndoesTheTurnsInTheirOrder) {
  const Vec<double, 3> angles{0.5, -1.2, 2.8};
  EXPECT_LT((roll_pitch_yaw(turned(0.5, -1.2, 2.8)) - angles).norm(), 1e-12);
}

TEST(RollPitchYawStd, IsThatOfTheAnglesNumericDerivative) {
  const Quat<double> R = turned(0.5, -0.9, 2.1);
  constexpr double kStep = 1e-6;
  Mat<double, 3, 3> J;
  for (int i = 0; i < 3; ++i) {
    const Vec<double, 3> step = kStep * Vec<double, 3>::Unit(i);
    J.col(i) = (roll_pitch_yaw(math::exp_so3<double>(step) * R) -
                roll_pitch_yaw(math::exp_so3<double>(Vec<double, 3>{-step}) * R)) /
               (2 * kStep);
  }
  Mat<double, 3, 3> P;
  P << 4, 1, 0.5, 1, 3, -0.2, 0.5, -0.2, 2;
  const Vec<double, 3> expected = (J * P * J.transpose()).diagonal().cwiseSqrt();
  // Central differences of 1e-6 leave rounding of about 1e-10.
  EXPECT_LT((roll_pitch_yaw_std(R, P) - expected).norm(), 1e-8);
}

TEST(RollPitchYawStd, IsUnknownWhereRollAndYawTurnTheSameWay) {
  const auto deviations = roll_pitch_yaw_std(turned(0, std::asin(1.0), 0), Mat<double, 3, 3>::Identity());
  EXPECT_TRUE(std::isnan(deviations.x()));
}

}  // namespace
}  // namespace articam::sim
