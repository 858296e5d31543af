#include "tests/core/vision/centre_bound.hpp"

#include <gtest/gtest.h>

#include "tests/core/vision/marker_scene.hpp"

namespace articam {
namespace {

sim::SceneMarker ring_of(double diameter_px) {
  const double z_m = test::kVga.fx_px * 2 * test::kRadius_m / diameter_px;
  return {
      model::MarkerKind::ring, {0.001, 0.002, z_m}, {0, 0, -1}, test::kRadius_m, test::kRadius_m * test::kWhyConRatio};
}

// Another program's figures for the same rings under blur 0.7 and noise 4: 0.004, 0.006, 0.007 and 0.009 px.
TEST(CentreBound, IsThatOfAnIndependentComputation) {
  const sim::RenderOptions options{.blur_px = 0.7, .noise_grey = 4};
  const auto bound_px = [&options](double diameter_px) {
    return test::centre_bound(ring_of(diameter_px), options).pose_px;
  };
  EXPECT_NEAR(bound_px(72), 0.004, 0.0006);
  EXPECT_NEAR(bound_px(31), 0.006, 0.0007);
  EXPECT_NEAR(bound_px(20), 0.007, 0.0007);
  EXPECT_NEAR(bound_px(12), 0.009, 0.0007);
}

TEST(CentreBound, GrowsWithNoiseAndWithWhatIsNotKnown) {
  const auto bound = [](const sim::RenderOptions& options) { return test::centre_bound(ring_of(20), options); };
  const auto four = bound({.noise_grey = 4}), eight = bound({.noise_grey = 8});
  EXPECT_NEAR(eight.pose_px / four.pose_px, 2, 0.01);  // rounding to grey levels is noise, too
  EXPECT_NEAR(eight.edges_px / four.edges_px, 2, 0.01);
  EXPECT_GT(four.edges_px, 1.1 * four.pose_px);  // the hole's edge tells of the centre
  EXPECT_GT(bound({.blur_px = 2}).pose_px, 1.5 * four.pose_px);
}

// Half as much light is half of all contrasts.
TEST(CentreBound, IsTheDoubleWhereLightIsHalf) {
  sim::SceneMarker ring = ring_of(20);
  const double even = test::centre_bound(ring, {}).edges_px;
  ring.centre_cam_m.x() = (4.0 / 7 * 640 - test::kVga.cx_px) / test::kVga.fx_px * ring.centre_cam_m.z();
  EXPECT_NEAR(test::centre_bound(ring, {.light_gradient = 8}).edges_px / even, 2, 0.2);
}

}  // namespace
}  // namespace articam
