#include "host_sim/world/gaussian_noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace articam::sim {
namespace {

constexpr int kWidth = 640, kHeight = 480;
constexpr double kCount = kWidth * kHeight;

std::vector<std::uint8_t> noisy(double sigma, std::uint64_t seed, std::uint64_t frame) {
  std::vector<std::uint8_t> pixels;
  GaussianNoise{sigma, seed}.digitise(GreyPlane{kWidth, kHeight, grey_q6(128)}, frame, pixels);
  return pixels;
}

TEST(GaussianNoise, HasItsMomentsAndNoCorrelationOfNeighbours) {
  constexpr double kSigma = 4;
  const auto pixels = noisy(kSigma, 7, 3);
  double sum = 0, squares = 0, fourth = 0, right = 0, below = 0;
  const auto at = [&](std::size_t i) { return pixels[i] - 128.0; };
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double x = at(i);
    sum += x, squares += x * x, fourth += x * x * x * x;
    if (i + 1 < pixels.size()) right += x * at(i + 1);
    if (i + kWidth < pixels.size()) below += x * at(i + kWidth);
  }
  // Five standard deviations of each statistic over this many pixels; 1/12 is the variance of rounding to whole greys.
  const double variance = kSigma * kSigma + 1.0 / 12, five = 5 / std::sqrt(kCount);
  EXPECT_NEAR(sum / kCount, 0, five * kSigma);
  EXPECT_NEAR(squares / kCount / variance, 1, five * std::sqrt(2) + 0.002) << "0.002: the tails end at 3.67 sigma";
  EXPECT_NEAR(fourth / kCount / (variance * variance), 3, five * std::sqrt(96) + 0.03);
  EXPECT_NEAR(right / kCount / variance, 0, five);
  EXPECT_NEAR(below / kCount / variance, 0, five);
}

TEST(GaussianNoise, IsAFunctionOfSeedFrameAndPixel) {
  EXPECT_EQ(noisy(4, 1, 5), noisy(4, 1, 5));
  EXPECT_NE(noisy(4, 1, 5), noisy(4, 1, 6));
  EXPECT_NE(noisy(4, 1, 5), noisy(4, 2, 5));
}

TEST(GaussianNoise, OfZeroOnlyRoundsAndClampsAtTheEnds) {
  EXPECT_EQ(noisy(0, 1, 0), std::vector<std::uint8_t>(static_cast<std::size_t>(kCount), 128));
  std::vector<std::uint8_t> pixels;
  GaussianNoise{100, 1}.digitise(GreyPlane{64, 64, 0}, 0, pixels);
  EXPECT_EQ(*std::min_element(pixels.begin(), pixels.end()), 0);
  EXPECT_GT(*std::max_element(pixels.begin(), pixels.end()), 200);
}

}  // namespace
}  // namespace articam::sim
