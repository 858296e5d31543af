#include "tools/identify/eye.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tools/identify/synthetic_recording.hpp"

namespace articam::identify {
namespace {

const vision::Circle<double> kMark{{0.12, -0.07, 0.85}, Vec<double, 3>{0.3, 0.2, -1}.normalized(), 0.025};

TEST(Eye, SeesAMarkWhereTheTrackerExpectsIt) {
  auto camera = cameras::kXtionVga;
  camera.distortion = {-0.2, 0.05, 1e-3, 2e-3};
  const auto seen = Eye{camera, {}}.see(kMark);
  const auto expected = tracker::image_of(kMark, vision::CameraModel<double>{camera});
  ASSERT_TRUE(seen && expected.ok());
  EXPECT_EQ(seen->pixel, expected.value().centre);
}

TEST(Eye, SeesNoMarkBehindIt) {
  const vision::Circle<double> behind{{0, 0, -1}, {0, 0, 1}, 0.025};
  EXPECT_FALSE((Eye{cameras::kXtionVga, {}}.see(behind)));
  EXPECT_FALSE((Eye{cameras::kXtionVga, {}}.pixel(behind)));
}

TEST(Eye, KnowsWhatEveryNumberOfTheCalibrationDoes) {
  const auto camera = cameras::kXtionVga;
  const auto before = Eye{camera, {}}.see(kMark);
  ASSERT_TRUE(before);
  for (int i = 0; i < CameraChange::kSize; ++i) {
    CameraChange change;
    change.by[i] = 1e-3;
    const auto after = Eye{camera, change}.pixel(kMark);
    ASSERT_TRUE(after);
    // The second order of such a step is a thousandth of the first.
    const Vec<double, 2> predicted = before->by_camera.col(i) * 1e-3;
    EXPECT_LT((*after - before->pixel - predicted).norm(), 2e-3 * predicted.norm() + 1e-6) << i;
  }
}

TEST(CameraChange, KeepsTheMeanFocalLengthWhereOnlyTheAspectChanges) {
  CameraChange change;
  change.by[CameraChange::kAspect] = 0.02;
  const auto camera = cameras::kXtionVga, other = changed(camera, change);
  EXPECT_NEAR(other.fx_px * other.fy_px, camera.fx_px * camera.fy_px, 1e-6);
  EXPECT_NEAR(other.fy_px / other.fx_px, std::exp(0.02), 1e-12);
}

}  // namespace
}  // namespace articam::identify
