#include "core/tracker/noise_scale.hpp"

#include <gtest/gtest.h>

#include "tests/support/random_state.hpp"

namespace articam::tracker {
namespace {

/// Frames of five spare equations whose deviations are `times` what was promised, under the factor of their time.
void learn(NoiseScale<double>& noise, double times, int frames, test::Random& random) {
  for (int i = 0; i < frames; ++i) {
    double chi2 = 0;
    for (int equation = 0; equation < 5; ++equation) {
      const double residual = times * random.gaussian();
      chi2 += residual * residual / noise.factor();
    }
    noise.learn(chi2, 5);
  }
}

TEST(NoiseScale, TrustsADetectorThatKeepsItsPromises) {
  NoiseScale<double> noise;
  test::Random random{1};
  EXPECT_GT(noise.factor(), 100);  // nothing is known yet
  learn(noise, 1, 100, random);
  EXPECT_LT(noise.factor(), 1.3);
  learn(noise, 0.5, 1000, random);
  EXPECT_EQ(noise.factor(), 1);  // but no more than it asks for
}

TEST(NoiseScale, FindsHowMuchLargerTheResidualsAre) {
  NoiseScale<double> noise;
  test::Random random{2};
  learn(noise, 3, 400, random);
  EXPECT_NEAR(noise.factor(), 9, 1.5);  // of some 500 equations: 6 %, four deviations with the start's rest
  learn(noise, 1, 400, random);
  EXPECT_LT(noise.factor(), 1.5);  // and forgets it
}

TEST(NoiseScale, LearnsNothingOfFramesWithoutSpareEquations) {
  NoiseScale<double> noise;
  const double before = noise.factor();
  noise.learn(0, 0);
  noise.learn(7, -1);
  EXPECT_EQ(noise.factor(), before);
}

}  // namespace
}  // namespace articam::tracker
