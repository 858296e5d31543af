#include "tools/report/view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/tools/report/static_table.hpp"

namespace articam::report {
namespace {

TEST(SampleViews, LookAtTheMiddleOfTheMarksFromTheirRangeAndTilt) {
  const modelgen::Table table = test::static_table("printer_drawer");
  Conditions conditions;
  conditions.camera = default_camera();
  const auto views = sample_views(table, conditions);
  EXPECT_EQ(views.size(), 3u * 25 * 5);  // ranges, directions, settings of two joints
  for (const View& view : views) {
    const Marks marks = place_marks(table, view.joints);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& centre : marks.centre) middle += centre / 6;
    const Vec3 seen = view.T_cam_obj * middle;
    EXPECT_NEAR(seen.x(), 0, 1e-12);
    EXPECT_NEAR(seen.y(), 0, 1e-12);
    EXPECT_NEAR(seen.z(), view.range_m, 1e-12);
    const Vec3 front = view.T_cam_obj.R * Vec3(0, 0, -1);  // all rings of the printer face -z
    EXPECT_NEAR(std::acos(std::min(1.0, -front.z())) * 180 / std::numbers::pi, view.tilt_deg, 1e-5);
    for (Eigen::Index j = 0; j < 2; ++j) {
      EXPECT_GE(view.joints[j], table.values()[static_cast<std::size_t>(j)]->q_min);
      EXPECT_LE(view.joints[j], table.values()[static_cast<std::size_t>(j)]->q_max);
    }
  }
}

TEST(SampleViews, KeepTheObjectsDownwardsDown) {
  Conditions conditions;
  conditions.camera = default_camera();
  for (const View& view : sample_views(test::static_table("printer_drawer"), conditions)) {
    const Vec3 down = view.T_cam_obj.R * Vec3::UnitY();
    EXPECT_NEAR(down.x(), 0, 1e-12);  // no roll
    EXPECT_GT(down.y(), 0.4);
  }
}

TEST(Limits, OfAJointWithoutAnyAreHalfATurnOrHalfAMetre) {
  modelgen::TableJoint joint;
  joint.q_min = -model::kUnlimited;
  joint.q_max = model::kUnlimited;
  joint.kind = model::JointKind::continuous;
  EXPECT_EQ(high_limit(joint), std::numbers::pi);
  joint.kind = model::JointKind::prismatic;
  EXPECT_EQ(low_limit(joint), -0.5);
}

}  // namespace
}  // namespace articam::report
