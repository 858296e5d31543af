#include "host_sim/world/object_state.hpp"

#include <gtest/gtest.h>

#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {
namespace {

TEST(SceneMarkers, StandWhereTheConfigurationPutsThemAndFaceTheCamera) {
  const auto object = PaperScenario::at(6.5);
  const auto markers = scene_markers<PaperScenario::Model>(object.q);
  ASSERT_EQ(markers.size(), 6u);
  for (const SceneMarker& marker : markers) {
    EXPECT_LT(marker.normal_cam.dot(marker.centre_cam_m), 0);
    EXPECT_NEAR(marker.normal_cam.norm(), 1, 1e-12);
    EXPECT_DOUBLE_EQ(marker.outer_radius_m, 0.025);
  }
  // The drawer's two marks are q2 apart, whatever the pose.
  EXPECT_NEAR((markers[4].centre_cam_m - markers[5].centre_cam_m).norm(), object.q.joints[1], 1e-12);
}

}  // namespace
}  // namespace articam::sim
