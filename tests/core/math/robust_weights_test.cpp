#include "core/math/robust_weights.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

TEST(HuberWeight, IsTheSlopeOfTheLossOverTheResidual) {
  constexpr double h = 1e-6;
  for (const double r : {0.1, 1.0, 1.3, 1.4, 3.0, 40.0}) {
    const double slope = (math::huber_loss((r + h) * (r + h)) - math::huber_loss((r - h) * (r - h))) / (2 * h);
    EXPECT_NEAR(math::huber_weight(r * r) * r, slope, 1e-8) << r;
  }
}

TEST(HuberLoss, IsContinuousWhereItTurnsLinear) {
  constexpr double k = 1.345;
  EXPECT_NEAR(math::huber_loss(k * k * (1 - 1e-12)), math::huber_loss(k * k * (1 + 1e-12)), 1e-11);
}

}  // namespace
}  // namespace articam
