#include "host_sim/world/limb.hpp"

#include <gtest/gtest.h>

#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {
namespace {

const Limb kLimb{{-0.2, 0, 0.5}, {0.2, 0, 0.5}, 0.03};

TEST(Limb, IsMetByRaysThatComeNearerThanItsRadius) {
  EXPECT_NEAR(kLimb.clearance({0, 0, 2}).way_m, -0.03, 1e-12);
  EXPECT_NEAR(kLimb.clearance({0, 0, 2}).depth_m, 0.5, 1e-12);
  // A ray that leaves the axis by the angle whose sine is 0.03 / 0.5 touches it.
  const double touching = 0.03 / std::sqrt(0.5 * 0.5 - 0.03 * 0.03);
  EXPECT_NEAR(kLimb.clearance({0, touching, 1}).way_m, 0, 1e-12);
  EXPECT_GT(kLimb.clearance({0.6, 0, 1}).way_m, 0) << "beyond its end";
  EXPECT_FALSE(kLimb.hides({0, 0, -1})) << "behind the camera";
}

TEST(Limb, HidesTheShareOfADiscThatLiesBehindIt) {
  const Vec<double, 3> facing{0, 0, -1};
  EXPECT_EQ(hidden_share({&kLimb, 1}, {0, 0, 1}, facing, 0.01), 1);
  EXPECT_EQ(hidden_share({&kLimb, 1}, {0, 0.3, 1}, facing, 0.01), 0);
  // Its edge crosses the disc's middle: half of the edge, and perhaps the centre and a point on either side.
  const double y = 0.03 / std::sqrt(0.5 * 0.5 - 0.03 * 0.03);
  EXPECT_NEAR(hidden_share({&kLimb, 1}, {0, y, 1}, facing, 0.01), 0.5, 0.12);
}

TEST(Limb, TouchesNoPixelOutsideItsBox) {
  const vision::CameraModel<double> camera{PaperScenario::camera()};
  const PixelBox box = image_box(kLimb, camera);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      if (u >= box.u_min_px && u <= box.u_max_px && v >= box.v_min_px && v <= box.v_max_px) continue;
      std::int16_t grey = 1000;
      paint_limb(kLimb, camera.unproject({u, v}).value().homogeneous(), camera.focal_px(), grey);
      ASSERT_EQ(grey, 1000) << u << " " << v;
    }
  }
}

}  // namespace
}  // namespace articam::sim
