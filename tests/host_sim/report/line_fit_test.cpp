#include "host_sim/report/line_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace articam::sim {
namespace {

TEST(LineFit, RecoversAnExactLineWithoutUncertainty) {
  const std::vector<double> x{0, 1, 2, 5, 7}, y{3, 1, -1, -7, -11};
  const LineFit fit = fit_line(x, y, 2);
  EXPECT_NEAR(fit.intercept, 3, 1e-12);
  EXPECT_NEAR(fit.slope, -2, 1e-12);
  EXPECT_NEAR(fit.slope_std, 0, 1e-12);
}

TEST(LineFit, IsZeroWithoutAnythingToFit) {
  const std::vector<double> x{1, 1, 1}, y{1, 2, 3};
  EXPECT_EQ(fit_line(x, y, 1).slope, 0);
  EXPECT_EQ(fit_line({}, {}, 1).slope_std, 0);
}

/// Share of 400 draws whose 95 % interval holds the true slope, with errors that follow each other: rho each step.
double coverage(double rho, std::size_t reach) {
  std::mt19937_64 random{11};
  std::normal_distribution<double> gauss;
  int held = 0;
  constexpr int kDraws = 400;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<double> x, y;
    double error = 0;
    for (int i = 0; i < 1500; ++i) {
      error = rho * error + gauss(random);
      x.push_back(std::sin(0.03 * i));
      y.push_back(0.5 * x.back() + error);
    }
    const Interval slope = fit_line(x, y, reach).slope_interval();
    held += slope.low < 0.5 && 0.5 < slope.high ? 1 : 0;
  }
  return static_cast<double>(held) / kDraws;
}

TEST(LineFit, HoldsTheTrueSlopeInItsIntervalEvenWhenErrorsAreCorrelated) {
  // Standard deviation of the share: 1.1 %. Bartlett weights are known to be a little short on correlated errors.
  EXPECT_NEAR(coverage(0.0, 30), 0.95, 0.04);
  EXPECT_NEAR(coverage(0.8, 30), 0.93, 0.05);
  EXPECT_LT(coverage(0.8, 0), 0.75) << "what happens when the correlation is ignored";
}

}  // namespace
}  // namespace articam::sim
