#include "tools/identify/freeze_joints.hpp"

#include <gtest/gtest.h>

#include "tests/tools/identify/static_sources.hpp"

namespace articam::identify {
namespace {

using modelgen::Diagnostics, modelgen::SourceFile;

/// Nothing but markers, each on a body: a start has numbers for joints that may be frozen.
SourceFile without_start(SourceFile markers) {
  markers.bytes.resize(std::min(markers.bytes.find("\nq0:") + 1, markers.bytes.size()));
  return markers;
}

/// The table of the written file, and of the original with the joint held by --freeze.
struct BothWays {
  modelgen::Table written, held;
};

BothWays freeze(const std::string& model, const Length& length) {
  const SourceFile urdf = test::static_source(model, ".urdf");
  const SourceFile markers = without_start(test::static_source(model, ".markers.yaml"));
  Diagnostics diagnostics;
  const auto text = freeze_joints(urdf, test::compile(urdf, markers).model, {length}, diagnostics);
  EXPECT_TRUE(text) << diagnostics.text();
  modelgen::ModelOptions options;
  options.freeze.push_back({length.joint, length.value});
  return {test::compile({"written.urdf", text.value_or("")}, markers).table,
          test::compile(urdf, markers, options).table};
}

/// Same joints; markers at the same places, within what 12 decimals of a written pose leave.
void expect_equal(const BothWays& both) {
  ASSERT_EQ(both.written.joints.size(), both.held.joints.size());
  ASSERT_EQ(both.written.markers.size(), both.held.markers.size());
  for (std::size_t j = 0; j < both.held.joints.size(); ++j) {
    EXPECT_EQ(both.written.joints[j].name, both.held.joints[j].name);
    EXPECT_LT((both.written.joints[j].T_parent_joint.t - both.held.joints[j].T_parent_joint.t).norm(), 1e-11);
  }
  for (std::size_t m = 0; m < both.held.markers.size(); ++m) {
    EXPECT_EQ(both.written.markers[m].body, both.held.markers[m].body);
    EXPECT_LT((both.written.markers[m].t_body_m - both.held.markers[m].t_body_m).norm(), 1e-11);
    EXPECT_LT((both.written.markers[m].normal - both.held.markers[m].normal).norm(), 1e-11);
  }
}

TEST(FreezeJoints, WritesWhatModelgenReadsAsTheFrozenModel) {
  expect_equal(freeze("printer_drawer", {"marker_distance", true, 0.1234567, 1e-5}));
  expect_equal(freeze("mire_distance", {"dot_distance", true, 0.14, 1e-5}));
  expect_equal(freeze("steering_wheel", {"column_tilt", false, -0.2345, 1e-4}));
  expect_equal(freeze("door", {"hinge", false, 0.7, 1e-4}));
}

TEST(FreezeJoints, HoldsWhatFollowsAJointWithIt) {
  const auto valve =
      test::compile(test::static_source("valve", ".urdf"), test::static_source("valve", ".markers.yaml"));
  const auto follower = std::ranges::find_if(valve.table.joints, [](const auto& joint) { return joint.leader >= 0; });
  ASSERT_NE(follower, valve.table.joints.end());
  const auto& leader = valve.table.joints[static_cast<std::size_t>(follower->leader)];
  const BothWays both = freeze("valve", {leader.name, false, 1.5, 1e-4});
  EXPECT_TRUE(both.written.joints.empty());
  expect_equal(both);
}

TEST(FreezeJoints, SaysValueAndDeviationInTheFile) {
  const SourceFile urdf = test::static_source("printer_drawer", ".urdf");
  Diagnostics diagnostics;
  const auto text = freeze_joints(urdf, test::compile(urdf, std::nullopt).model,
                                  {{"marker_distance", true, 0.12, 2.5e-6}}, diagnostics);
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("identified as 0.1200000 m, standard deviation 0.0000025 m"), std::string::npos) << *text;
  EXPECT_NE(text->find("The printer of the paper"), std::string::npos) << "the author's comments are gone";
}

TEST(FreezeJoints, RefusesAPartOfAPlanarJoint) {
  const SourceFile urdf{"planar.urdf",
                        R"(<robot name="r"><link name="a"/><link name="b"/>
<joint name="p" type="planar"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint></robot>)"};
  const SourceFile markers{"m.yaml",
                           "markers:\n  - {frame: b, type: dot, diameter_m: 0.01, polarity: light_on_dark}\n"};
  Diagnostics diagnostics;
  EXPECT_FALSE(freeze_joints(urdf, test::compile(urdf, markers).model, {{"p.x", true, 0.1, 1e-4}}, diagnostics));
  EXPECT_NE(diagnostics.text().find("planar"), std::string::npos) << diagnostics.text();
}

}  // namespace
}  // namespace articam::identify
