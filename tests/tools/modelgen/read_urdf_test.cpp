#include "tools/modelgen/read_urdf.hpp"

#include <gtest/gtest.h>

#include "tests/tools/modelgen/compile_text.hpp"

namespace articam::modelgen {
namespace {

using test::robot;

std::string messages(const std::string& urdf) {
  Diagnostics diagnostics;
  (void)read_urdf({"m.urdf", urdf}, diagnostics);
  return diagnostics.text();
}

std::string joint(const std::string& parts) {
  return robot("<joint name='j' type='revolute'><parent link='a'/><child link='b'/>\n" + parts + "</joint>");
}

TEST(ReadUrdf, KeepsEveryValueAndItsLine) {
  Diagnostics diagnostics;
  const auto model = read_urdf({"m.urdf", robot("<link name='a'/><link name='b'/>\n"
                                                "<joint name='j' type='prismatic'>\n"
                                                "<parent link='a'/>\n<child link='b'/>\n"
                                                "<origin xyz='1 2 3' rpy='.1 .2 .3'/>\n"
                                                "<axis xyz='0 0 2'/>\n<limit lower='-1' upper='2'/></joint>")},
                               diagnostics);
  ASSERT_TRUE(model);
  ASSERT_EQ(model->joints.size(), 1u);
  const UrdfJoint& j = model->joints[0];
  EXPECT_EQ(j.type, JointType::prismatic);
  EXPECT_EQ(j.origin_xyz, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(j.origin_rpy, (std::array<double, 3>{.1, .2, .3}));
  EXPECT_EQ(j.axis, (std::array<double, 3>{0, 0, 2}));
  EXPECT_EQ(j.lower, -1);
  EXPECT_EQ(j.upper, 2);
  EXPECT_EQ((std::array{j.line, j.parent_line, j.child_line, j.axis_line, j.limit_line}), (std::array{3, 4, 5, 7, 8}));
}

TEST(ReadUrdf, GivesAbsentPartsTheirDefault) {
  Diagnostics diagnostics;
  const auto model = read_urdf({"m.urdf", joint("")}, diagnostics);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->joints[0].axis, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(model->joints[0].origin_xyz, (std::array<double, 3>{}));
  EXPECT_FALSE(model->joints[0].has_limit);
}

TEST(ReadUrdf, TellsTheLineAndTheElementOfWhatIsMissingOrMalformed) {
  EXPECT_EQ(messages(robot("<link/>")), "m.urdf:2: link '': attribute name is missing\n");
  EXPECT_EQ(messages(robot("<joint name='j' type='ball'/>")),
            "m.urdf:2: joint 'j': type 'ball' is none of revolute, continuous, prismatic, fixed, planar, floating\n"
            "m.urdf:2: joint 'j': <parent link=\"...\"/> is missing\n"
            "m.urdf:2: joint 'j': <child link=\"...\"/> is missing\n");
  EXPECT_EQ(messages(joint("<origin xyz='1 2'/>")),
            "m.urdf:3: joint 'j' <origin>: xyz=\"1 2\" is not three finite numbers\n");
  EXPECT_EQ(messages(joint("<axis xyz='0 nan 1'/>")),
            "m.urdf:3: joint 'j' <axis>: xyz=\"0 nan 1\" is not three finite numbers\n");
  EXPECT_EQ(messages(joint("<axis/>")), "m.urdf:3: joint 'j' <axis>: attribute xyz is missing\n");
  EXPECT_EQ(messages(joint("<limit lower='1,5' upper='2'/>")),
            "m.urdf:3: joint 'j' <limit>: lower=\"1,5\" is not a finite number\n");
  EXPECT_EQ(messages(joint("<origin xyz='2e6 0 0'/>")),
            "m.urdf:3: joint 'j' <origin>: xyz=\"2e6 0 0\" is beyond 1e6\n");
  EXPECT_EQ(messages(joint("<axis xyz='1 0 0'/>\n<axis xyz='0 1 0'/>")),
            "m.urdf:4: joint 'j' <axis>: is given twice; keep one\n");
}

TEST(ReadUrdf, RefusesADocumentThatIsNotOneRobot) {
  EXPECT_EQ(messages("<sdf/>"), "m.urdf:1: document: the outermost element is not <robot>\n");
  EXPECT_EQ(messages("<robot name='a'/>\n<robot name='b'/>"),
            "m.urdf:2: document: a second outermost element; one file holds one robot\n");
  EXPECT_EQ(messages("<robot name='a'>\n<link name='b'>\n</robot>"),
            "m.urdf:2: document: not well-formed XML: a tag here is not closed, or closed by another name\n");
}

TEST(ReadUrdf, RefusesDeclarationsBeforeParsingThem) {
  const char* const kRefused = ": document: document types and entities are not taken; remove the declaration\n";
  EXPECT_EQ(messages("<!DOCTYPE r [<!ENTITY a 'b'>]>\n<robot name='&a;'/>"), std::string("m.urdf:1") + kRefused);
  EXPECT_EQ(messages(robot("<!ENTITY a 'b'>")), std::string("m.urdf:2") + kRefused);
  EXPECT_EQ(messages(robot("<!-- <!DOCTYPE of a comment --><![CDATA[<!ENTITY]]>")), "");
}

TEST(ReadUrdf, RefusesATagOnWhichTheParserWouldTakeForEver) {
  std::string attributes;
  for (int i = 0; i < 64; ++i) attributes += " a" + std::to_string(i) + "='=>='";
  EXPECT_EQ(messages(robot("<b x=''" + attributes + "/>")), "m.urdf:2: document: a tag has more than 64 attributes\n");
  EXPECT_EQ(messages(robot("<b" + attributes + "/><c" + attributes + "/>")), "");
}

TEST(ReadUrdf, RefusesDeepNestingAndTooManyLinks) {
  const auto nested = [](int levels) {  // the robot itself is one level
    std::string text;
    for (int i = 1; i < levels; ++i) text += "<a>";
    for (int i = 1; i < levels; ++i) text += "</a>";
    return robot(text);
  };
  EXPECT_EQ(messages(nested(kMaxXmlDepth)), "");
  for (const int levels : {kMaxXmlDepth + 1, 99, 200, 100'000}) {
    EXPECT_EQ(messages(nested(levels)), "m.urdf:2: document: elements are nested deeper than 32 levels\n") << levels;
  }
  std::string links;
  for (int i = 0; i < 256; ++i) links += "<link name='l" + std::to_string(i) + "'/>";
  EXPECT_EQ(messages(robot(links)), "");
  EXPECT_EQ(messages(robot(links + "\n<link name='x'/>")), "m.urdf:3: robot: more than 256 links or joints\n");
}

TEST(ReadUrdf, NamesWhatXacroLeftOver) {
  EXPECT_EQ(messages(robot("<xacro:door/>")),
            "m.urdf:2: xacro:door: warning: a macro left over, ignored; run `xacro FILE.xacro > FILE.urdf`\n");
  EXPECT_EQ(
      messages(joint("<origin xyz='${width} 0 0'/>")),
      "m.urdf:3: joint 'j' <origin>: xyz=\"${width} 0 0\" is not three finite numbers, but an expression of xacro; "
      "run `xacro FILE.xacro > FILE.urdf`\n");
  EXPECT_EQ(messages(robot("<link name='$(arg side)_arm'/>")),
            "m.urdf:2: link '$(arg side)_arm': name=\"$(arg side)_arm\" is not a name, but an expression of xacro; run "
            "`xacro FILE.xacro > FILE.urdf`\n");
}

TEST(ReadUrdf, ReadsOnlyTheDirectChildrenOfTheRobot) {
  Diagnostics diagnostics;
  const auto model =
      read_urdf({"m.urdf", robot("<link name='a'/><transmission name='t'><joint name='j'/></transmission>"
                                 "<gazebo><link name='b'/></gazebo><!-- <link name='c'/> -->")},
                diagnostics);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->links.size(), 1u);
  EXPECT_TRUE(model->joints.empty());
  EXPECT_EQ(diagnostics.text(), "");
}

TEST(ReadUrdf, TakesFilesAsPeopleSaveThem) {
  const std::string body = "<link name='a'/>";
  const std::string named = " xmlns:xacro='http://www.ros.org/wiki/xacro'";
  for (const std::string& text : std::initializer_list<std::string>{
           "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<robot name='r'>\r\n" + body + "\r\n</robot>\r\n",
           "<!-- late --><?xml version='1.0'?><robot name='r'>" + body + "</robot>",
           "<robot name='r'>\n<?pi <!ENTITY?><!-- <? --><link name='a'/><?unfinished</robot> ?></robot>",
           "<robot name='r' xmlns='http://www.ros.org'>" + body + "</robot>",
           "<robot name='r'" + named + ">" + body + "</robot>",
           std::string("<u:robot xmlns:u='u' name='r'><u:link name='a'/></u:robot>")}) {
    Diagnostics diagnostics;
    const auto model = read_urdf({"m.urdf", text}, diagnostics);
    ASSERT_TRUE(model) << text;
    EXPECT_EQ(diagnostics.text(), "") << text;
    EXPECT_EQ(model->robot, "r") << text;
    EXPECT_EQ(model->links.size(), 1u) << text;
  }
}

TEST(ReadUrdf, RefusesARotationThatItWouldHaveToIgnore) {
  EXPECT_EQ(messages(joint("<origin quat_xyzw='0 0 0 1'/>")),
            "m.urdf:3: joint 'j' <origin>: quat_xyzw is not read; give the rotation as rpy\n");
}

}  // namespace
}  // namespace articam::modelgen
