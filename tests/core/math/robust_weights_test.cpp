#include "core/math/robust_weights.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

TEST(HuberWeight, IsTheSlopeOfTheLossOverTheResidual) {
  constexpr double h = 1e-6, k = 1.345;
  for (const double r : {0.1, 1.0, 1.3, 1.4, 3.0, 40.0}) {
    const double slope = (math::huber_loss((r + h) * (r + h), k) - math::huber_loss((r - h) * (r - h), k)) / (2 * h);
    EXPECT_NEAR(math::huber_weight(r * r, k) * r, slope, 1e-8) << r;
  }
}

TEST(HuberLoss, IsContinuousWhereItTurnsLinear) {
  constexpr double k = 1.345;
  EXPECT_NEAR(math::huber_loss(k * k * (1 - 1e-12), k), math::huber_loss(k * k * (1 + 1e-12), k), 1e-11);
}

}  // namespace
}  // namespace articam
