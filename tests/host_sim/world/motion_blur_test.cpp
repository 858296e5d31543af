#include "host_sim/world/motion_blur.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace articam::sim {
namespace {

constexpr int kSide = 41, kMiddle = 20, kBright = 16000;
constexpr PixelBox kAll{0, 0, kSide - 1, kSide - 1};

struct Moments {
  double sum, u, v, uu, uv, vv;
};

/// Of the image of a single bright pixel: the blur's kernel.
Moments kernel(const Vec<double, 2>& motion_px) {
  GreyPlane point{kSide, kSide, 0}, moved{kSide, kSide, 0};
  point.row(kMiddle)[kMiddle] = kBright;
  MotionBlur{motion_px}.apply(point, kAll, moved);
  Moments m{};
  for (int v = 0; v < kSide; ++v) {
    for (int u = 0; u < kSide; ++u) {
      const double share = moved.row(v)[u] / static_cast<double>(kBright), du = u - kMiddle, dv = v - kMiddle;
      m.sum += share, m.u += share * du, m.v += share * dv;
      m.uu += share * du * du, m.uv += share * du * dv, m.vv += share * dv * dv;
    }
  }
  return m;
}

TEST(MotionBlur, IsALineAboutThePixel) {
  for (const Vec<double, 2>& motion : {Vec<double, 2>{8, 0}, {0, -5}, {6.5, 3}, {-4, 9}, {0.3, 0.2}}) {
    const Moments m = kernel(motion);
    // 30 taps, each rounded by up to half of 1 / 16000, at up to 5 px from the middle.
    EXPECT_NEAR(m.sum, 1, 1e-3);
    EXPECT_NEAR(m.u, 0, 5e-3);
    EXPECT_NEAR(m.v, 0, 5e-3);
    // A line's variance is a twelfth of its square; between pixels each axis takes up to a quarter more.
    const Mat<double, 2, 2> line = motion * motion.transpose() / 12;
    EXPECT_GE(m.uu, line(0, 0) - 0.01);
    EXPECT_LE(m.uu, line(0, 0) + 0.26);
    EXPECT_GE(m.vv, line(1, 1) - 0.01);
    EXPECT_LE(m.vv, line(1, 1) + 0.26);
    EXPECT_NEAR(m.uv, line(0, 1), 0.1);
  }
}

TEST(MotionBlur, CopiesWithoutMotionAndLeavesAFlatImageAsItIs) {
  EXPECT_TRUE(MotionBlur({0, 0}).still());
  EXPECT_EQ(MotionBlur({0, 0}).reach_px(), 0);
  const GreyPlane flat{kSide, kSide, 7777};
  GreyPlane moved{kSide, kSide, 0};
  MotionBlur{{7, 3}}.apply(flat, kAll, moved);
  EXPECT_EQ(moved.q6, flat.q6);
}

}  // namespace
}  // namespace articam::sim
