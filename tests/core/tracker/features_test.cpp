#include "core/tracker/features.hpp"

#include <gtest/gtest.h>

#include "core/tracker/associate.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/core/vision/circle_scene.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/wide_lenses.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
using tracker::FeatureKind;

std::array<CameraParameters, 4> cameras() {
  const auto [plumb_bob, rational, equidistant] = test::wide_lenses();
  return {test::camera_with(DistortionModel::plumb_bob, {}), plumb_bob, rational, equidistant};
}

/// The printer near enough to fill most of the image.
model::Configuration<M, double> near_printer() {
  auto q = test::nominal_printer<M, double>();
  q.T_cam_obj.t = {0.02, 0.02, 0.35};
  return q;
}

TEST(Features, AreWhereADetectorSeesTheMarkersSoThatTheirMatchesHaveNoError) {
  const auto q = near_printer();
  const auto kinematics = model::forward_kinematics<M, double>(q.joints);
  for (const auto& p : cameras()) {
    const vision::CameraModel<double> camera{p};
    const auto features = tracker::predict_features<M, double>(q, camera);
    vision::Detections detections;
    for (const auto& feature : features) {
      if (!feature.visible) continue;
      ASSERT_TRUE(detections.push_back({.kind = feature.kind, .outer = feature.image, .centre_variance_q24 = 16 << 8}));
    }
    ASSERT_GE(detections.size(), 4u);
    const auto matches = tracker::associate<M, double>(features, detections, camera, 0.02);
    ASSERT_EQ((tracker::count<M, double>(matches)), static_cast<int>(detections.size()));
    for (std::size_t i = 0; i < matches.size(); ++i) {
      if (!matches[i].matched) continue;
      const auto circle =
          tracker::circle_in_camera(q.T_cam_obj, kinematics.markers[i], M::kMarkers[i].outer_diameter_m);
      // Q16 of a pixel, and what a lens makes of it
      EXPECT_LT((matches[i].s_star - test::image_of(circle).centre).norm(), 4e-5 / p.fx_px) << i;
    }
  }
}

TEST(Features, ThatArePointsAreAtTheProjectionOfTheCentreAndTheirImageIsStillTheEllipse) {
  const auto q = near_printer();
  const auto kinematics = model::forward_kinematics<M, double>(q.joints);
  for (const auto& p : cameras()) {
    const vision::CameraModel<double> camera{p};
    const auto circles = tracker::predict_features<M, double>(q, camera);
    const auto points = tracker::predict_features<M, double>(q, camera, FeatureKind::point);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i].visible) continue;
      const Vec<double, 3> centre = q.T_cam_obj * kinematics.markers[i].centre;
      EXPECT_LT((points[i].pixel - camera.project(centre.hnormalized())).norm(), 1e-12);
      EXPECT_EQ(points[i].image, circles[i].image);
      EXPECT_NEAR(vision::from_q16(circles[i].image.u_q16), circles[i].pixel.x(), 1e-5);
      EXPECT_NEAR(vision::semi_major(vision::from_q16<double>(points[i].image)), points[i].radius_px, 3e-5);
    }
  }
}

TEST(Features, AreNotVisibleWhereTheLensModelEnds) {
  auto q = near_printer();
  q.T_cam_obj.t.x() = 0.6;  // beyond the fold, where the polynomial throws it back into the image
  const vision::CameraModel<double> folding{test::camera_with(DistortionModel::plumb_bob, {-0.4})};
  for (const auto& feature : tracker::predict_features<M, double>(q, folding)) EXPECT_FALSE(feature.visible);
}

}  // namespace
}  // namespace articam
