#include "core/vision/lens_ellipse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/math/so3.hpp"
#include "core/vision/circle_poses.hpp"
#include "core/vision/detector.hpp"
#include "core/vision/imaged_ellipse.hpp"
#include "host_sim/world/renderer.hpp"
#include "tests/support/wide_lenses.hpp"

namespace articam {
namespace {

/// A ring whose centre is seen in this pixel, its image of about this radius, tilted by half a radian.
vision::Circle<double> ring_at(const Vec<double, 2>& pixel, double radius_px,
                               const vision::CameraModel<double>& camera) {
  const Vec<double, 3> ray = camera.unproject(pixel).value().homogeneous();
  const double px_per_m = std::sqrt(camera.project_with_slope(ray.head<2>()).value().J.determinant());
  return {ray, -(math::exp_so3<double>({0.3, -0.4, 0}) * ray.normalized()), radius_px / px_per_m};
}

vision::Detections detected(sim::Renderer& renderer, const vision::Circle<double>& ring) {
  std::vector<std::uint8_t> pixels;
  renderer.render(std::vector<sim::SceneMarker>{{model::MarkerKind::ring, ring.centre, ring.normal, ring.radius,
                                                 ring.radius * 50 / 122}},
                  0, pixels);
  const auto detector = std::make_unique<vision::Detector>();
  vision::Detections detections;
  EXPECT_EQ(detector->detect({pixels.data(), 640, 480, 640}, detections), Status::ok);
  return detections;
}

// Without noise the detector itself is off by up to 0.01 px in the centre, 0.02 px in an axis; the image of the
// ellipse's centre would be off by up to 3 px here.
TEST(WideLens, ShowsRingsToTheDetectorWhereTheyArePredictedAndTheirPosesComeBack) {
  for (const auto& p : test::wide_lenses()) {
    const vision::CameraModel<double> camera{p};
    sim::Renderer renderer{p, {.blur_px = 0.7, .noise_grey = 0, .clutter = false}};
    for (const auto& pixel : {Vec<double, 2>{480, 120}, {570, 410}, {60, 60}}) {
      for (const double radius_px : {12.0, 36.0}) {
        const auto ring = ring_at(pixel, radius_px, camera);
        const auto predicted = vision::distorted_ellipse(vision::imaged_ellipse(ring).value(), camera);
        const auto detections = detected(renderer, ring);
        ASSERT_TRUE(predicted.ok());
        ASSERT_EQ(detections.size(), 1u);
        const auto seen = vision::from_q16<double>(detections[0].outer);
        EXPECT_LT((seen.centre - predicted.value().centre).norm(), 0.015);
        EXPECT_LT((seen.M - predicted.value().M).norm(), 0.03);  // 0.02 px in each axis

        const auto poses = vision::circle_poses(detections[0].outer, ring.radius, camera);
        ASSERT_TRUE(poses.ok());
        EXPECT_NEAR(poses.value().range_m() / ring.centre.norm(), 1, 0.03 / radius_px);
      }
    }
  }
}

}  // namespace
}  // namespace articam
