#include "core/math/robust_weights.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

constexpr double kK = 1.345;

double loss(double r) { return (r * r - math::huber_excess(r, kK)) / 2; }

TEST(HuberWeight, IsTheSlopeOfTheLossOverTheResidual) {
  constexpr double h = 1e-5;
  for (const double r : {1.4, 3.0, 40.0}) {
    const double slope = (loss(r + h) - loss(r - h)) / (2 * h);
    EXPECT_NEAR(math::huber_weight(r, kK) * r, slope, 1e-9 + 2e-16 * r * r / h) << r;  // rounding of r^2, over h
  }
}

TEST(HuberWeight, IsThatOfLeastSquaresWhereTheLossTurnsLinear) {
  EXPECT_DOUBLE_EQ(math::huber_weight(kK, kK), 1);
  EXPECT_DOUBLE_EQ(math::huber_weight(2 * kK, kK, 0.5), 0.25);
  EXPECT_EQ(math::huber_excess(kK, kK), 0);
}

}  // namespace
}  // namespace articam
