#include "tools/modelgen/check_model.hpp"

#include <gtest/gtest.h>

#include "tests/tools/modelgen/compile_text.hpp"

namespace articam::modelgen {
namespace {

using test::compile_text;
using test::robot;

const std::string kLinks = "<link name='a'/><link name='b'/>\n";

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& type = "fixed", const std::string& rest = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         rest + "</joint>\n";
}

/// Messages of a robot whose only warning of no markers is left away.
std::string messages(const std::string& body, ModelOptions options = {}) {
  std::string text = compile_text(robot(body), {}, std::move(options)).messages;
  const std::string kBlind = "m.urdf: robot: warning: no markers and no points: nothing of it can be observed\n";
  const auto at = text.find(kBlind);
  return at == std::string::npos ? text : text.erase(at, kBlind.size());
}

TEST(CheckModel, RefusesWhatIsNotATree) {
  EXPECT_EQ(messages(""), "m.urdf:1: robot: has no links\n");
  EXPECT_EQ(messages(kLinks), "m.urdf:2: link 'b': a second root beside 'a'; join it by a joint or remove it\n");
  EXPECT_EQ(messages(kLinks + joint("j", "a", "b") + joint("k", "b", "a")),
            "m.urdf:2: link 'a': hangs on a cycle of joints; cut the cycle\n"
            "m.urdf:2: link 'b': hangs on a cycle of joints; cut the cycle\n");
  EXPECT_EQ(messages(kLinks + "<link name='c'/><link name='d'/>\n" + joint("j", "a", "b") + joint("k", "c", "d") +
                     joint("l", "d", "c")),
            "m.urdf:3: link 'c': hangs on a cycle of joints; cut the cycle\n"
            "m.urdf:3: link 'd': hangs on a cycle of joints; cut the cycle\n");
  EXPECT_EQ(messages(kLinks + joint("j", "a", "b") + joint("k", "a", "b")),
            "m.urdf:4: joint 'k': link 'b' already hangs on joint 'j'\n");
  EXPECT_EQ(messages("<link name='a'/>" + joint("j", "a", "x")),
            "m.urdf:2: joint 'j': child link 'x' is not declared\n");
  EXPECT_EQ(messages("<link name='a'/>" + joint("j", "x", "a")),
            "m.urdf:2: joint 'j': parent link 'x' is not declared\n");
  EXPECT_NE(messages("<link name='a'/>" + joint("j", "a", "a")).find("parent and child are the same link"),
            std::string::npos);
}

TEST(CheckModel, RefusesNamesTakenTwiceAndNamesThatCodeCannotCarry) {
  EXPECT_EQ(messages("<link name='a'/>\n<link name='a'/>"),
            "m.urdf:3: link 'a': the name is taken since line 2; rename one\n"
            "m.urdf:3: link 'a': a second root beside 'a'; join it by a joint or remove it\n");
  EXPECT_EQ(messages("<link name='switch'/>"), "m.urdf:2: link 'switch': the name is a C++ keyword; rename it\n");
  for (const std::string name : {"a&quot;}; int evil() {", "a,b", "a\\", "a&#10;b", "a;b", "a&lt;b"}) {
    EXPECT_NE(messages("<link name='" + name + "'/>").find("generated code and CSV columns cannot carry"),
              std::string::npos)
        << name;
  }
  EXPECT_NE(messages("<link name='a&#xD800;'/>").find("is not UTF-8"), std::string::npos);
  EXPECT_NE(messages("<link name='" + std::string(129, 'a') + "'/>").find("longer than 128"), std::string::npos);
}

TEST(CheckModel, TakesNamesOfRealFiles) {
  for (const std::string name :
       {"left_finger[0]/joint-base", "joint_0.0", "plane::xy::base", "a b", "\xE9\x96\xA2\xE7\xAF\x80"}) {
    EXPECT_EQ(messages("<link name='" + name + "'/>"), "") << name;
  }
}

TEST(CheckModel, LinkAndJointMayShareAName) { EXPECT_EQ(messages(kLinks + joint("a", "a", "b")), ""); }

TEST(CheckModel, RefusesAZeroAxisOnAMovingJointOnly) {
  EXPECT_EQ(messages(kLinks + joint("j", "a", "b", "continuous", "\n<axis xyz='0 0 0'/>")),
            "m.urdf:4: joint 'j': the axis is zero; give its direction, e.g. xyz=\"0 0 1\"\n");
  EXPECT_EQ(messages(kLinks + joint("j", "a", "b", "fixed", "<axis xyz='0 0 0'/>")), "");
  EXPECT_NE(messages(kLinks + joint("j", "a", "b", "planar", "<axis xyz='0 0 0'/>")).find("the axis is zero"),
            std::string::npos);
}

TEST(CheckModel, TakesUnclearLimitsAsUnlimitedAndSaysSo) {
  const auto limits = [](const char* type, const char* limit) {
    const auto outcome =
        compile_text(robot(kLinks + joint("j", "a", "b", type, limit)), {}, test::with_points({"p=b:0,0,0"}));
    EXPECT_EQ(outcome.model->table.joints[0].q_min, -model::kUnlimited);
    EXPECT_EQ(outcome.model->table.joints[0].q_max, model::kUnlimited);
    return outcome.messages;
  };
  const std::string kNone = "m.urdf:3: joint 'j': warning: no <limit lower=\"..\" upper=\"..\"/>: taken as unlimited\n";
  EXPECT_EQ(limits("revolute", ""), kNone);
  EXPECT_EQ(limits("prismatic", "<limit effort='1' velocity='1'/>"), kNone);
  EXPECT_EQ(limits("prismatic", "<limit lower='1' upper='0'/>"),
            "m.urdf:3: joint 'j': warning: lower is above upper: taken as unlimited\n");
  EXPECT_EQ(limits("continuous", "<limit lower='0' upper='1'/>"),
            "m.urdf:3: joint 'j': warning: limits of a continuous joint are ignored\n");
  EXPECT_EQ(limits("continuous", ""), "");
  EXPECT_EQ(limits("prismatic", "<limit lower='-1e30' upper='1e30'/>"), "");
}

TEST(CheckModel, AddsTheLinkWorldAndARobotNameAndSaysSo) {
  EXPECT_EQ(messages("<link name='a'/>" + joint("j", "world", "a")),
            "m.urdf:2: joint 'j': warning: parent link 'world' is not declared: added\n");
  EXPECT_NE(compile_text("<robot><link name='a'/></robot>").messages.find("robot: warning: has no name"),
            std::string::npos);
}

TEST(CheckModel, RefusesMarkersAndOptionsThatNameNothing) {
  const std::string kRing = "type: dot, diameter_m: 0.01, polarity: light_on_dark}\n";
  EXPECT_EQ(compile_text(robot("<link name='a'/>"), "markers:\n  - {frame: x, " + kRing).messages,
            "m.yaml:2: marker 'x': the URDF has no link 'x'\n");
  EXPECT_EQ(
      compile_text(robot("<link name='a'/>"), "markers:\n  - {frame: a, " + kRing + "  - {frame: a, " + kRing).messages,
      "m.yaml:3: marker 'a': is given twice; each marker needs its own link and name\n");
  EXPECT_EQ(messages("<link name='a'/>", test::with_points({"p=x:0,0,0"})),
            "--poi: point 'p': the URDF has no link 'x'\n");
  ModelOptions options;
  options.root = "x";
  EXPECT_EQ(messages(kLinks + joint("j", "a", "b"), options), "--root: link 'x': the URDF has no such link\n");
}

TEST(CheckModel, TellsAllErrorsOfBothFilesInOneRun) {
  const auto outcome = compile_text(robot("<link name='a'/><link name='a'/>\n<joint name='j' type='ball'>"
                                          "<parent link='a'/><child link='b'/><origin xyz='1'/></joint>"),
                                    "markers:\n  - {frame: z, type: cross}\nq0: [0, 0, -1, 1, 0, 0, 0]\n");
  EXPECT_FALSE(outcome.model);
  for (const char* part : {"m.yaml:2: marker 1 type", "m.urdf:3: joint 'j': type 'ball'", "<origin>: xyz=\"1\"",
                           "the name is taken since line 2", "child link 'b' is not declared", "no link 'z'",
                           "m.yaml:3: q0: pz is not positive"}) {
    EXPECT_NE(outcome.messages.find(part), std::string::npos) << part;
  }
}

TEST(IsTypeName, WantsCamelCase) {
  EXPECT_TRUE(is_type_name("PrinterDrawer2"));
  for (const char* name : {"", "printer", "2Door", "Printer_Drawer", "A b", "A::B", "A;", "_A"}) {
    EXPECT_FALSE(is_type_name(name)) << name;
  }
}

}  // namespace
}  // namespace articam::modelgen
