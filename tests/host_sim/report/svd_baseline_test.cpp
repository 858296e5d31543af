#include "host_sim/report/svd_baseline.hpp"

#include <gtest/gtest.h>

#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {
namespace {

using Model = PaperScenario::Model;

/// Detections and matches as an ideal detector gives them of an object seen from the front, where a ring's image is a
/// circle.
struct Seen {
  vision::Detections detections;
  tracker::Matches<Model, double> matches{};

  explicit Seen(const model::Configuration<Model, double>& q) {
    const CameraParameters camera = PaperScenario::camera();
    const auto q16 = [](double px) { return static_cast<std::int32_t>(px * 65536); };
    for (const SceneMarker& marker : scene_markers<Model>(q)) {
      const Vec<double, 2> centre = vision::CameraModel<double>{camera}.project(marker.centre_cam_m.hnormalized());
      const std::int32_t radius = q16(camera.fx_px * marker.outer_radius_m / marker.centre_cam_m.z());
      vision::Detection detection;
      detection.outer = {q16(centre.x()), q16(centre.y()), radius, 0, radius};
      matches[detections.size()].matched = true;
      matches[detections.size()].detection = static_cast<int>(detections.size());
      (void)detections.push_back(detection);
    }
  }
};

model::Configuration<Model, double> from_the_front() {
  model::Configuration<Model, double> q;
  q.T_cam_obj.t = {0.02, 0.01, 0.7};
  q.joints = {0.05, 0.12};
  return q;
}

const vision::CameraModel<double> kCamera{PaperScenario::camera()};

TEST(SvdBaseline, RecoversBaseDrawerAndDistanceFromIdealDetections) {
  const auto q = from_the_front();
  const Seen seen{q};
  const auto found = svd_baseline<Model>(seen.matches, seen.detections, kCamera);
  ASSERT_TRUE(found);
  // The mean of a ring's two positions is off by radius^2 / range * sin(tilt to its ray): 0.9 mm times at most 0.2.
  EXPECT_LT((found->T_cam_obj.t - q.T_cam_obj.t).norm(), 1.8e-4);
  EXPECT_NEAR(found->joints[0], 0.05, 1.8e-4);
  EXPECT_NEAR(found->joints[1], 0.12, 1.8e-4);
}

TEST(SvdBaseline, SaysNothingWithoutThreeBaseMarksOrWithoutAJointsMark) {
  Seen seen{from_the_front()};
  seen.matches[0].matched = false;
  EXPECT_TRUE(svd_baseline<Model>(seen.matches, seen.detections, kCamera)) << "three are enough";
  seen.matches[1].matched = false;
  EXPECT_FALSE(svd_baseline<Model>(seen.matches, seen.detections, kCamera));
  Seen without_drawer{from_the_front()};
  without_drawer.matches[5].matched = false;
  EXPECT_FALSE(svd_baseline<Model>(without_drawer.matches, without_drawer.detections, kCamera));
}

}  // namespace
}  // namespace articam::sim
