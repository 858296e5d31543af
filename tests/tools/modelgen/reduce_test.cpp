#include "tools/modelgen/reduce.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "core/math/so3.hpp"
#include "tests/tools/modelgen/compile_text.hpp"
#include "tests/tools/modelgen/urdf_oracle.hpp"

namespace articam::modelgen {
namespace {

using test::compile_text;
using test::Matrix4;
using test::robot;

constexpr unsigned kSeed = 20260101;

/// Where the table puts its markers: one pose per body.
std::vector<Pose<double>> body_poses(const Table& table, const std::map<std::string, double>& values) {
  std::vector<Pose<double>> T_obj_body;
  for (const TableJoint& joint : table.joints) {
    const auto leader = static_cast<std::size_t>(joint.leader);
    const double q =
        joint.leader < 0 ? values.at(joint.name) : joint.ratio * values.at(table.joints[leader].name) + joint.offset;
    const Vec<double, 3> step = joint.axis * q;
    const bool slides = joint.kind == model::JointKind::prismatic;
    const Pose<double> moved = slides ? Pose<double>{Quat<double>::Identity(), step}
                                      : Pose<double>{math::exp_so3<double>(step), Vec<double, 3>::Zero()};
    const auto row = static_cast<std::size_t>(joint.parent);
    const Pose<double> T_obj_parent = joint.parent < 0 ? Pose<double>{} : T_obj_body.at(row);
    T_obj_body.push_back(T_obj_parent * joint.T_parent_joint * moved);
  }
  return T_obj_body;
}

/// The table's points, which carry the names of their links, stand where the second reading puts the links.
void expect_same_places(const Table& table, const test::UrdfOracle& oracle, const std::string& root,
                        std::map<std::string, double> values, std::mt19937& random) {
  SCOPED_TRACE(testing::Message() << "root " << root << ", seed " << kSeed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const TableJoint* joint : table.values()) values[joint->name] = uniform(random);
  const auto T_obj_body = body_poses(table, values);
  const Matrix4 T_obj_old = inverse(oracle.pose(root, values));
  for (const TableMarker& marker : table.markers) {
    const Matrix4 expected = T_obj_old * oracle.pose(marker.name, values);
    const Pose<double> T = marker.body < 0 ? Pose<double>{} : T_obj_body.at(static_cast<std::size_t>(marker.body));
    const Vec<double, 3> centre = T * marker.t_body_m, normal = T.R * marker.normal;
    for (int i = 0; i < 3; ++i) {
      // Some 30 products of numbers of a few metres, each row rounded by 5e-16.
      EXPECT_NEAR(centre[i], expected[static_cast<std::size_t>(i)][3], 1e-12) << marker.name;
      EXPECT_NEAR(normal[i], expected[static_cast<std::size_t>(i)][2], 1e-12) << marker.name;
    }
  }
}

ModelOptions points_at(const std::vector<std::string>& links) {
  ModelOptions options;
  for (const std::string& link : links) {
    Marker point;
    point.name = point.frame = link;
    options.points.push_back(point);
  }
  return options;
}

const std::string kArm = robot(
    "<link name='base'/><link name='mount'/><link name='upper'/><link name='lower'/><link name='tip'/><link "
    "name='lid'/>"
    "<joint name='weld' type='fixed'><parent link='base'/><child link='mount'/>"
    "<origin xyz='.1 .2 .3' rpy='.4 -.5 .6'/></joint>"
    "<joint name='shoulder' type='revolute'><parent link='mount'/><child link='upper'/>"
    "<origin xyz='0 .1 0' rpy='1 2 3'/><axis xyz='1 1 0'/><limit lower='-2' upper='2'/></joint>"
    "<joint name='reach' type='prismatic'><parent link='upper'/><child link='lower'/>"
    "<origin xyz='.5 0 0' rpy='0 1.5707963267948966 0'/><axis xyz='0 3 4'/><limit lower='-2' upper='2'/></joint>"
    "<joint name='wrist' type='fixed'><parent link='lower'/><child link='tip'/>"
    "<origin xyz='.1 0 0' rpy='3.141592653589793 0 0'/></joint>"
    "<joint name='hinge' type='continuous'><parent link='base'/><child link='lid'/><axis xyz='0 0 1'/></joint>");

TEST(Reduce, PutsEveryLinkWhereASecondReadingPutsIt) {
  std::mt19937 random(kSeed);
  const test::UrdfOracle oracle(kArm);
  const auto outcome = compile_text(kArm, {}, points_at({"base", "mount", "upper", "lower", "tip", "lid"}));
  ASSERT_TRUE(outcome.model) << outcome.messages;
  EXPECT_EQ(outcome.model->table.joints.size(), 3u);
  for (int i = 0; i < 20; ++i) expect_same_places(outcome.model->table, oracle, "base", {}, random);
}

TEST(Reduce, KeepsEveryDistanceAndJointValueWhenAnotherLinkBecomesTheRoot) {
  std::mt19937 random(kSeed);
  const test::UrdfOracle oracle(kArm);
  for (const char* root : {"mount", "upper", "lower", "tip", "lid"}) {
    ModelOptions options = points_at({"base", "mount", "upper", "lower", "tip", "lid"});
    options.root = root;
    const auto outcome = compile_text(kArm, {}, options);
    ASSERT_TRUE(outcome.model) << outcome.messages;
    for (int i = 0; i < 5; ++i) expect_same_places(outcome.model->table, oracle, root, {}, random);
  }
}

TEST(Reduce, HoldsAFrozenJointAtItsValue) {
  std::mt19937 random(kSeed);
  const test::UrdfOracle oracle(kArm);
  for (const char* root : {"base", "tip"}) {
    ModelOptions options = points_at({"base", "mount", "upper", "lower", "tip", "lid"});
    options.root = root;
    options.freeze = {{"shoulder", 0.7}, {"reach", -0.2}};
    const auto outcome = compile_text(kArm, {}, options);
    ASSERT_TRUE(outcome.model) << outcome.messages;
    ASSERT_EQ(outcome.model->table.joints.size(), 1u);
    expect_same_places(outcome.model->table, oracle, root, {{"shoulder", 0.7}, {"reach", -0.2}}, random);
  }
}

const std::string kGripper = robot(
    "<link name='palm'/><link name='wheel'/><link name='left'/><link name='right'/><link name='tip'/>"
    "<joint name='left_slide' type='prismatic'><parent link='palm'/><child link='left'/><axis xyz='0 1 0'/>"
    "<limit lower='0' upper='1'/><mimic joint='right_slide' multiplier='-1' offset='.01'/></joint>"
    "<joint name='right_slide' type='prismatic'><parent link='palm'/><child link='right'/><axis xyz='0 0 3'/>"
    "<limit lower='0' upper='1'/><mimic joint='motor' multiplier='.02'/></joint>"
    "<joint name='motor' type='continuous'><parent link='palm'/><child link='wheel'/><axis xyz='1 1 0'/></joint>"
    "<joint name='curl' type='revolute'><parent link='left'/><child link='tip'/><axis xyz='0 0 1'/>"
    "<limit lower='0' upper='1'/><mimic joint='motor' offset='-.3'/></joint>");

TEST(Reduce, GivesGearedJointsOneValue) {
  std::mt19937 random(kSeed);
  const test::UrdfOracle oracle(kGripper);
  for (const char* root : {"palm", "tip", "wheel"}) {
    ModelOptions options = points_at({"palm", "wheel", "left", "right", "tip"});
    options.root = root;
    const auto outcome = compile_text(kGripper, {}, options);
    ASSERT_TRUE(outcome.model) << outcome.messages;
    ASSERT_EQ(outcome.model->table.joints.size(), 4u);
    ASSERT_EQ(outcome.model->table.values().size(), 1u);
    EXPECT_EQ(outcome.model->table.values()[0]->name, "motor");
    for (int i = 0; i < 5; ++i) expect_same_places(outcome.model->table, oracle, root, {}, random);
  }
}

TEST(Reduce, HoldsTheGearsOfAFrozenMotor) {
  std::mt19937 random(kSeed);
  ModelOptions options = points_at({"wheel", "tip"});
  options.freeze = {{"motor", 0.5}};
  const auto outcome = compile_text(kGripper, {}, options);
  ASSERT_TRUE(outcome.model) << outcome.messages;
  const Table& table = outcome.model->table;
  EXPECT_TRUE(table.joints.empty());
  ASSERT_EQ(table.frozen.size(), 4u);
  EXPECT_EQ(table.frozen[0].name, "left_slide");
  EXPECT_DOUBLE_EQ(table.frozen[0].value, -0.02 * 0.5 + 0.01);
  expect_same_places(table, test::UrdfOracle(kGripper), "palm", {{"motor", 0.5}}, random);
}

TEST(Reduce, MovesPlanarAndFloatingJointsByTheirParts) {
  std::mt19937 random(kSeed);
  for (const std::string axis : {"0 0 1", "1 0 0", "0 0 -2", "1 2 -3"}) {
    const std::string text = robot(
        "<link name='table'/><link name='book'/><link name='lid'/>"
        "<joint name='slides' type='planar'><parent link='table'/><child link='book'/>"
        "<origin xyz='.1 .2 .3' rpy='1 2 3'/><axis xyz='" +
        axis +
        "'/></joint>"
        "<joint name='flies' type='floating'><parent link='book'/><child link='lid'/>"
        "<origin xyz='.3 0 .1' rpy='-1 .5 .2'/></joint>");
    for (const char* root : {"table", "lid"}) {
      ModelOptions options = points_at({"table", "book", "lid"});
      options.root = root;
      const auto outcome = compile_text(text, {}, options);
      ASSERT_TRUE(outcome.model) << outcome.messages;
      ASSERT_EQ(outcome.model->table.joints.size(), 9u);
      for (int i = 0; i < 5; ++i) {
        expect_same_places(outcome.model->table, test::UrdfOracle(text), root, {}, random);
      }
    }
  }
}

TEST(Reduce, AgreesWithTheSecondReadingOnEveryUrdfOfTheCorpusThatItTakes) {
  const std::filesystem::path corpus = ARTICAM_URDF_CORPUS;
  if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "no URDF corpus beside the repository";
  std::mt19937 random(kSeed);
  int taken = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    if (entry.path().extension() != ".urdf") continue;
    std::ifstream stream(entry.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!compile_text(text).model) continue;  // its reasons are other tests' matter
    const test::UrdfOracle oracle(text);
    const auto outcome = compile_text(text, {}, points_at(oracle.leaves));
    ASSERT_TRUE(outcome.model) << entry.path() << outcome.messages;
    SCOPED_TRACE(entry.path().filename());
    expect_same_places(outcome.model->table, oracle, outcome.model->table.root_link, {}, random);
    ++taken;
  }
  EXPECT_EQ(taken, 55) << "the language has shrunk";
}

TEST(Reduce, LeavesOutJointsThatMoveNoMarker) {
  const auto outcome = compile_text(kArm, {}, points_at({"lid"}));
  ASSERT_TRUE(outcome.model);
  ASSERT_EQ(outcome.model->table.joints.size(), 1u);
  EXPECT_EQ(outcome.model->table.joints[0].name, "hinge");
  EXPECT_EQ(outcome.model->table.markers[0].body, 0);
  EXPECT_EQ(outcome.messages,
            "m.urdf:2: joint 'shoulder': warning: moves no marker: left out of the table\n"
            "m.urdf:2: joint 'reach': warning: moves no marker: left out of the table\n");
}

TEST(Reduce, KeepsAllJointsOfAModelWithoutAnyMarker) {
  const auto outcome = compile_text(kArm);
  ASSERT_TRUE(outcome.model);
  EXPECT_EQ(outcome.model->table.joints.size(), 3u);
}

TEST(Reduce, OrdersParentsFirstHoweverTheFileDoes) {
  const auto outcome =
      compile_text(robot("<link name='c'/><link name='b'/><link name='a'/>"
                         "<joint name='second' type='continuous'><parent link='b'/><child link='c'/></joint>"
                         "<joint name='first' type='continuous'><parent link='a'/><child link='b'/></joint>"));
  ASSERT_TRUE(outcome.model);
  EXPECT_EQ(outcome.model->table.root_link, "a");
  EXPECT_EQ(outcome.model->table.joints[0].name, "first");
  EXPECT_EQ(outcome.model->table.joints[1].name, "second");
  EXPECT_EQ(outcome.model->table.joints[1].parent, 0);
}

TEST(Reduce, ChecksTheStartAgainstTheTable) {
  const auto start = [](const std::string& q0) {
    return compile_text(kArm,
                        "markers:\n  - {frame: tip, type: dot, diameter_m: 0.01, polarity: light_on_dark}\n"
                        "q0: [" +
                            q0 + "]\n")
        .messages;
  };
  const std::string kUnused = "m.urdf:2: joint 'hinge': warning: moves no marker: left out of the table\n";
  EXPECT_EQ(start("0, 0, 1, 1, 0, 0, 0, 0, 0"), kUnused);
  EXPECT_EQ(start("0, 0, 1, 1, 0, 0, 0, 0"),
            kUnused + "m.yaml:3: q0: has 8 numbers instead of 9: px py pz qw qx qy qz shoulder reach\n");
  EXPECT_EQ(start("0, 0, 1, 1, 1, 0, 0, 0, 0"), "m.yaml:3: q0: its quaternion has norm 1.414, not 1\n");
  EXPECT_EQ(start("0, 0, 1, 1, 0, 0, 0, 0, 1e300"), "m.yaml:3: q0: a number is beyond 1e+06\n");
  EXPECT_EQ(start("0, 0, -1, 1, 0, 0, 0, 0, 0"),
            "m.yaml:3: q0: pz is not positive: the base is not in front of the camera\n");
  EXPECT_EQ(start("0, 0, 1"), "m.yaml:3: q0: has 3 numbers; it needs px py pz qw qx qy qz, then the joints\n");
  EXPECT_EQ(start("0, 0, 1, 1, 0, 0, 0, 5, 0"), kUnused + "m.yaml:3: q0: warning: shoulder is outside its limits\n");
}

TEST(PoseOf, TurnsHalfWithoutResidue) {
  const Pose<double> T = pose_of({0, 0, 0}, {3.141592653589793, 0, 0});
  EXPECT_EQ(rounded(T.R.w()), 0);
  EXPECT_EQ(rounded(T.R.x()), 1);
}

TEST(Rounded, KeepsWhatWasTypedAndDropsWhatArithmeticLeft) {
  EXPECT_EQ(rounded(0.1 + 0.2), 0.3);
  EXPECT_EQ(rounded(6e-17), 0);
  EXPECT_EQ(rounded(0.9999999999999998), 1);
  EXPECT_EQ(rounded(0.123456789012345), 0.123456789012345);
  EXPECT_EQ(rounded(-123456.75), -123456.75);
  EXPECT_FALSE(std::signbit(rounded(-1e-20)));
}

}  // namespace
}  // namespace articam::modelgen
