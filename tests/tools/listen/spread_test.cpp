#include "tools/listen/spread.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/random_state.hpp"

namespace articam::listen {
namespace {

TEST(Spread, GivesQuantilesToOnePercentAndExactExtremes) {
  test::Random random{9};
  Spread spread;
  std::vector<double> times;
  for (int i = 0; i < 10001; ++i) {
    times.push_back(std::pow(10, random.uniform(-6.5, 2)));
    spread.take(times.back());
  }
  std::ranges::sort(times);
  EXPECT_EQ(spread.min(), times.front());
  EXPECT_EQ(spread.max(), times.back());
  for (const double share : {0.0, 0.1, 0.5, 0.99, 1.0}) {
    const double exact = times[static_cast<std::size_t>(share * 10000 + 0.5)];
    EXPECT_NEAR(spread.quantile(share) / exact, 1, 0.01) << share << ", seed 9";  // the width of a class
  }
}

TEST(Spread, TakesEveryNumber) {
  Spread spread;
  EXPECT_EQ(spread.quantile(0.5), 0);
  for (const double t_s : {-1.0, 0.0, 1e300, std::numeric_limits<double>::infinity()}) spread.take(t_s);
  EXPECT_EQ(spread.size(), 4u);
  EXPECT_EQ(spread.min(), 0);
}

}  // namespace
}  // namespace articam::listen
