#include "tools/modelgen/resolve_mimics.hpp"

#include <gtest/gtest.h>

#include "tests/tools/modelgen/compile_text.hpp"

namespace articam::modelgen {
namespace {

using test::compile_text;
using test::robot;

/// A chain of links l0, l1, ...; line 2 holds the links, then each joint its own line.
std::string chain(const std::vector<std::string>& joints) {
  std::string links = "<link name='l0'/>", text;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    links += "<link name='l" + std::to_string(i + 1) + "'/>";
    const std::size_t blank = joints[i].find(' ');
    text += "\n<joint name='" + joints[i].substr(0, blank) + "' " + joints[i].substr(blank) + "<parent link='l" +
            std::to_string(i) + "'/><child link='l" + std::to_string(i + 1) + "'/></joint>";
  }
  return robot(links + text);
}

const std::string kTurns = "type='continuous'>", kFixed = "type='fixed'>";
std::string mimics(const std::string& leader, const std::string& rest = "") {
  return kTurns + "<mimic joint='" + leader + "' " + rest + "/>";
}

test::Outcome compile(const std::vector<std::string>& joints, std::vector<Freeze> freeze = {}) {
  ModelOptions options = test::with_points({});
  Marker tip;
  tip.name = "tip";
  tip.frame = "l" + std::to_string(joints.size());
  options.points.push_back(tip);
  options.freeze = std::move(freeze);
  return compile_text(chain(joints), {}, options);
}

TEST(ResolveMimics, MultipliesChainsOutInAnyOrder) {
  for (const auto& joints : {std::vector{"a " + kTurns, "b " + mimics("a", "multiplier='2' offset='.5'"),
                                         "c " + mimics("b", "multiplier='-3' offset='1'")},
                             std::vector{"c " + mimics("b", "multiplier='-3' offset='1'"),
                                         "b " + mimics("a", "multiplier='2' offset='.5'"), "a " + kTurns}}) {
    const auto outcome = compile(joints);
    ASSERT_TRUE(outcome.model) << outcome.messages;
    EXPECT_EQ(outcome.messages, "");
    for (const TableJoint& joint : outcome.model->table.joints) {
      if (joint.name == "a") {
        EXPECT_EQ(joint.leader, -1);
        continue;
      }
      EXPECT_EQ(outcome.model->table.joints.at(static_cast<std::size_t>(joint.leader)).name, "a");
      EXPECT_EQ(joint.ratio, joint.name == "b" ? 2 : -6);       // c = -3 b + 1
      EXPECT_EQ(joint.offset, joint.name == "b" ? 0.5 : -0.5);  //   = -3 (2 a + .5) + 1
    }
  }
}

TEST(ResolveMimics, HoldsWhatMimicsSomethingThatStandsStill) {
  const auto fixed = compile({"a " + kFixed, "b " + mimics("a", "offset='.25'"), "c " + mimics("b", "multiplier='2'")});
  ASSERT_TRUE(fixed.model) << fixed.messages;
  EXPECT_EQ(fixed.messages,
            "m.urdf:4: joint 'b': warning: mimics joint 'a', which stands still: held at 0.25\n"
            "m.urdf:5: joint 'c': warning: mimics joint 'b', which stands still: held at 0.5\n");
  EXPECT_TRUE(fixed.model->table.joints.empty());
  const auto zero = compile({"a " + kTurns, "b " + mimics("a", "multiplier='0' offset='.25'")});
  EXPECT_EQ(zero.messages, "m.urdf:4: joint 'b': warning: mimics by a multiplier of 0: held at 0.25\n");
  EXPECT_EQ(compile({"a " + kTurns, "b " + kFixed + "<mimic joint='a'/>"}).messages,
            "m.urdf:4: joint 'b': warning: <mimic> of a fixed joint is ignored\n");
}

TEST(ResolveMimics, RefusesLeadersThatDoNotExistAndCycles) {
  EXPECT_EQ(compile({"a " + mimics("x")}).messages,
            "m.urdf:3: joint 'a': mimics joint 'x', which the URDF does not have; correct the name\n");
  EXPECT_EQ(compile({"a " + mimics("a")}).messages,
            "m.urdf:3: joint 'a': the joints that it mimics form a cycle; let one of them move freely\n");
  const auto cycle = compile({"a " + mimics("b"), "b " + mimics("c"), "c " + mimics("b")});
  EXPECT_FALSE(cycle.model);
  EXPECT_EQ(std::count(cycle.messages.begin(), cycle.messages.end(), '\n'), 3);
  EXPECT_EQ(compile({"a type='planar'>", "b " + mimics("a")}).messages,
            "m.urdf:4: joint 'b': mimics joint 'a', which has several values; name a part of it, as in NAME.x\n");
  EXPECT_EQ(compile({"a " + kTurns, "b type='floating'><mimic joint='a'/>"}).messages,
            "m.urdf:4: joint 'b': a planar or floating joint cannot mimic; remove <mimic>\n");
  EXPECT_EQ(compile({"a " + kTurns, "b " + mimics("a", "multiplier='2e6'")}).messages,
            "m.urdf:4: joint 'b' <mimic>: multiplier or offset is beyond 1e6\n");
  EXPECT_EQ(
      compile({"a " + kTurns, "b " + mimics("a", "multiplier='1e4'"), "c " + mimics("b", "multiplier='1e4'")}).messages,
      "m.urdf:5: joint 'c': the multipliers or offsets of its chain grow beyond 1e6\n");
}

TEST(ResolveMimics, LetsAPartOfAPlanarJointLead) {
  const auto outcome = compile({"a type='planar'>", "b " + mimics("a.theta", "multiplier='2'")});
  ASSERT_TRUE(outcome.model) << outcome.messages;
  EXPECT_EQ(outcome.model->table.values().size(), 3u);
}

TEST(ResolveMimics, HoldsALeaderWithinTheLimitsOfItsFollowers) {
  const auto limited = [](const char* multiplier, const char* lower, const char* upper) {
    return compile({"a type='revolute'><limit lower='-1' upper='2'/>",
                    std::string("b type='revolute'><limit lower='") + lower + "' upper='" + upper +
                        "'/><mimic joint='a' offset='.5' multiplier='" + multiplier + "'/>"});
  };
  const auto turned = limited("-2", "-1.5", "9");  // b = -2 a + .5 is above -1.5 while a is below 1
  EXPECT_EQ(turned.messages, "m.urdf:4: joint 'b': warning: its limits hold 'a', which it mimics, between -1 and 1\n");
  EXPECT_EQ(turned.model->table.joints[0].q_min, -1);
  EXPECT_EQ(turned.model->table.joints[0].q_max, 1);
  const auto wide = limited("1", "-0.5000001", "2.5");  // the digits of a rounded limit narrow nothing
  EXPECT_EQ(wide.messages, "");
  EXPECT_EQ(wide.model->table.joints[0].q_max, 2);
  const auto open = limited("1", "0", "1e9");  // above -.5, and without an end
  EXPECT_EQ(open.model->table.joints[0].q_min, -.5);
  EXPECT_EQ(open.model->table.joints[0].q_max, 2);
  for (const char* lower : {"7", "2.5"}) {  // out of reach, or in reach at one end only: a slip in the file
    const auto never = limited("1", lower, "8");
    EXPECT_EQ(never.messages,
              "m.urdf:4: joint 'b': warning: its limits leave 'a', which it mimics, no room: they are ignored\n");
    EXPECT_EQ(never.model->table.joints[0].q_max, 2);
  }
}

TEST(ResolveMimics, LeavesAContinuousLeaderItsTurns) {
  const auto outcome =
      compile({"a " + kTurns, "b type='prismatic'><limit lower='0' upper='1'/><mimic joint='a' multiplier='.1'/>"});
  ASSERT_TRUE(outcome.model) << outcome.messages;
  EXPECT_EQ(outcome.messages, "");
  EXPECT_EQ(outcome.model->table.joints[0].q_max, model::kUnlimited);
}

TEST(ResolveMimics, RefusesToFreezeWhatCannotBeFrozen) {
  EXPECT_EQ(
      compile({"a " + kFixed, "b " + kTurns, "c " + mimics("b")}, {{"x", 0}, {"a", 0}, {"c", 0}, {"b", 0}, {"b", 1}})
          .messages,
      "--freeze: joint 'x': the URDF has no such joint\n"
      "--freeze: joint 'a': is fixed already\n"
      "--freeze: joint 'c': mimics 'b'; freeze that one\n"
      "--freeze: joint 'b': is given twice, or stands still already\n");
}

TEST(Prune, KeepsALeaderThatMovesNoMarkerForItsValueOnly) {
  const auto outcome = compile_text(
      robot("<link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
            "<joint name='above' type='continuous'><parent link='a'/><child link='b'/></joint>"
            "<joint name='motor' type='continuous'><parent link='b'/><child link='c'/><origin xyz='1 2 3'/></joint>"
            "<joint name='belt' type='prismatic'><parent link='a'/><child link='d'/><limit lower='0' upper='1'/>"
            "<mimic joint='motor' multiplier='.1'/></joint>"),
      {}, test::with_points({"p=d:0,0,0"}));
  ASSERT_TRUE(outcome.model) << outcome.messages;
  EXPECT_EQ(outcome.messages,
            "m.urdf:2: joint 'above': warning: moves no marker: left out of the table\n"
            "m.urdf:2: joint 'motor': warning: moves no marker, but a joint that mimics it does: kept for its value\n");
  const auto& joints = outcome.model->table.joints;
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0].name, "motor");
  EXPECT_EQ(joints[0].parent, -1);
  EXPECT_EQ(joints[1].leader, 0);
}

}  // namespace
}  // namespace articam::modelgen
