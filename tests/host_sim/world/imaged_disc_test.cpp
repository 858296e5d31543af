#include "host_sim/world/imaged_disc.hpp"

#include <gtest/gtest.h>

#include "core/vision/imaged_circle.hpp"

namespace articam::sim {
namespace {

constexpr double kFocal_px = 525;

Vec<double, 3> ray(double u_px, double v_px) { return {u_px / kFocal_px, v_px / kFocal_px, 1}; }

CornerRays corners(int u, int v) {
  return {ray(u - 0.5, v - 0.5), ray(u + 0.5, v - 0.5), ray(u - 0.5, v + 0.5), ray(u + 0.5, v + 0.5)};
}

struct Covered {
  double area{}, u{}, v{};
};

Covered covered(const ImagedDisc& disc, int reach) {
  Covered sum;
  for (int v = -reach; v <= reach; ++v) {
    for (int u = -reach; u <= reach; ++u) {
      const double share = disc.coverage(corners(u, v));
      sum.area += share, sum.u += share * u, sum.v += share * v;
    }
  }
  sum.u /= sum.area, sum.v /= sum.area;
  return sum;
}

// Only the cells at the edge err, each by at most 0.002, with either sign.
constexpr double kAreaTolerance = 0.002;

TEST(ImagedDisc, SeenFromTheFrontCoversTheAreaOfItsImage) {
  for (const double radius_m : {0.002, 0.010, 0.025, 0.06}) {
    const ImagedDisc disc{{0.0007, -0.0004, 0.7}, {0, 0, -1}, radius_m};
    const double radius_px = kFocal_px * radius_m / 0.7;
    const double area = 3.14159265358979 * radius_px * radius_px;
    EXPECT_NEAR(covered(disc, 60).area / area, 1, kAreaTolerance) << radius_px << " px";
  }
}

TEST(ImagedDisc, TiltedHasItsCentroidAtThePoleOfTheLineAtInfinity) {
  const Vec<double, 3> centre{0.01, -0.02, 0.3};  // near: the centroid is 0.8 px off the projected centre
  for (const double tilt_rad : {0.0, 0.5, 1.0}) {
    const Vec<double, 3> normal{0.6 * std::sin(tilt_rad), 0.8 * std::sin(tilt_rad), -std::cos(tilt_rad)};
    const auto s = vision::imaged_centre<double>({centre, normal, 0.025});
    ASSERT_TRUE(s.ok());
    const Covered sum = covered({centre, normal, 0.025}, 110);
    // A centroid is not quite the conic's centre in pixels of finite size, and lines cut corners: measured 2e-4.
    EXPECT_NEAR(sum.u, kFocal_px * s.value().x(), 1e-3);
    EXPECT_NEAR(sum.v, kFocal_px * s.value().y(), 1e-3);
  }
}

TEST(ImagedDisc, CallsNoCrossedPixelClear) {
  const ImagedDisc disc{{0.01, 0.02, 0.5}, Vec<double, 3>{0.5, 0.3, -0.8}.normalized(), 0.004};
  const double bend = disc.bend(1 / kFocal_px);
  for (int v = -60; v <= 60; ++v) {
    for (int u = -60; u <= 60; ++u) {
      const CornerRays corner = corners(u, v);
      const auto [low, high] =
          std::minmax({disc.side(corner[0]), disc.side(corner[1]), disc.side(corner[2]), disc.side(corner[3])});
      if (low > bend) {
        EXPECT_EQ(disc.coverage(corner), 0) << u << " " << v;
      } else if (high < -bend) {
        EXPECT_EQ(disc.coverage(corner), 1) << u << " " << v;
      }
    }
  }
}

}  // namespace
}  // namespace articam::sim
