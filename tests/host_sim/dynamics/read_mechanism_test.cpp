#include "host_sim/dynamics/read_mechanism.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "host_sim/dynamics/rigid_body_dynamics.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"

namespace articam::sim {
namespace {

TEST(ReadMechanism, TakesLimitsAndFrictionFromTheFile) {
  const Mechanism printer = read_mechanism(urdf::kPrinterDrawer);
  ASSERT_EQ(printer.num_values(), 2);
  const MechanismJoint& slide = printer.of_value(0);
  EXPECT_EQ(slide.name, "drawer_slide");
  EXPECT_EQ(slide.q_max, 0.35);
  EXPECT_EQ(slide.friction, 3);
  EXPECT_EQ(slide.damping, 6);
  EXPECT_EQ(slide.max_effort, 0);
  EXPECT_EQ(slide.max_rate, model::kUnlimited) << "a velocity of 0 is no limit";
  EXPECT_EQ(slide.inertia(0, 0), 1.2);
}

TEST(ReadMechanism, HoldsAJointWhereItIsTold) {
  const Mechanism whole = read_mechanism(urdf::kPrinterDrawer);
  const Mechanism held = read_mechanism(urdf::kPrinterDrawer, {{"marker_distance", 0.12}});
  ASSERT_EQ(held.num_values(), 1);
  const Vec<double, 3> gravity = Vec<double, 3>::Zero();
  RigidBodyDynamics moving{whole, gravity}, standing{held, gravity};
  moving.update((JointVec(2) << 0.05, 0.12).finished(), JointVec::Zero(2));
  standing.update(JointVec::Constant(1, 0.05), JointVec::Zero(1));
  const Pose<double> a = moving.pose(whole.link("drawer_marker_1")), b = standing.pose(held.link("drawer_marker_1"));
  EXPECT_LT((a.t - b.t).norm() + a.R.angularDistance(b.R), 1e-12);
}

TEST(ReadMechanism, AddsUpWhatIsFixedToABody) {
  const Mechanism two = read_mechanism(
      R"(<robot name="r"><link name="a"/>
      <link name="b"><inertial><mass value="1"/><inertia ixx="0.1" iyy="0.2" izz="0.3"/></inertial></link>
      <link name="c"><inertial><origin xyz="0 0 1"/><mass value="2"/></inertial></link>
      <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="1 0 0"/>
        <limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
      <joint name="f" type="fixed"><parent link="b"/><child link="c"/><origin xyz="0 3 0"/></joint></robot>)");
  ASSERT_EQ(two.joints.size(), 1U);
  EXPECT_EQ(two.joints[0].inertia(0, 0), 3);
  EXPECT_NEAR(two.joints[0].inertia(3, 3), 0.1 + 2 * (9 + 1), 1e-12);
}

TEST(ReadMechanism, SaysWhyItRefuses) {
  const auto reason = [](std::string_view urdf) -> std::string {
    try {
      read_mechanism(urdf);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "";
  };
  EXPECT_NE(reason("<robot>"), "");
  EXPECT_EQ(reason("<robot><link name='a'/><link name='b'/></robot>"), "URDF: two roots: a and b");
  EXPECT_EQ(reason("<robot><link name='a'/><link name='b'/><joint name='j' type='floating'><parent link='a'/>"
                   "<child link='b'/></joint></robot>"),
            "URDF: joint j is neither of one axis nor fixed");
  EXPECT_EQ(reason("<robot><link name='a'/><link name='b'/><joint name='j' type='revolute'><origin xyz='1 2'/>"
                   "<parent link='a'/><child link='b'/></joint></robot>"),
            "URDF: xyz=\"1 2\" holds no 3 numbers");
}

}  // namespace
}  // namespace articam::sim
