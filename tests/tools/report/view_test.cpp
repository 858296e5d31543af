#include "tools/report/view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
    EXPECT_NEAR((view.T_cam_obj.R * view.from - Vec3(0, 0, -1)).norm(), 0, 1e-12);
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

TEST(SampleViews, MoveEveryJointByItself) {
  Conditions conditions;
  conditions.camera = default_camera();
  const modelgen::Table table = test::static_table("stress24");
  const auto views = sample_views(table, conditions);
  for (Eigen::Index j = 0; j < 24; ++j) {
    for (Eigen::Index k = 0; k < j; ++k) {
      const auto share = [&](const View& v, Eigen::Index i) {
        const auto& joint = *table.values()[static_cast<std::size_t>(i)];
        return (v.joints[i] - low_limit(joint)) / (high_limit(joint) - low_limit(joint));
      };
      const auto apart = [&](const View& v) { return std::abs(share(v, j) - share(v, k)) > 0.7; };
      EXPECT_TRUE(std::any_of(views.begin(), views.end(), apart)) << j << " and " << k;
    }
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
