#include "tools/modelgen/emit_header.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <locale>

#include "tests/tools/modelgen/compile_text.hpp"

namespace articam::modelgen {
namespace {

using test::compile_text;
using test::robot;

const std::string kDoor = robot(
    "<link name='frame'/><link name='door'/>"
    "<joint name='hinge' type='revolute'><parent link='frame'/><child link='door'/>"
    "<origin xyz='.25 1000.5 0'/><axis xyz='0 0 1'/><limit lower='-.5' upper='1.57'/></joint>");

struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(EmitHeader, IsTheSameInEveryLocale) {
  const std::string expected = compile_text(kDoor).model->header;
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where the machine has it
  const auto outcome = compile_text(kDoor);
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  ASSERT_TRUE(outcome.model) << outcome.messages;
  EXPECT_EQ(outcome.model->header, expected);
}

TEST(EmitHeader, NamesTheSourcesWithoutTheirFolders) {
  CompileJob job{{"/some/machine/door.urdf", kDoor}, SourceFile{"else/door.yaml", "markers: []\n"}, "Door", {}};
  Diagnostics diagnostics;
  const std::string header = compile_model(job, diagnostics)->header;
  EXPECT_NE(header.find("//   shape    door.urdf  sha256 " + sha256(kDoor)), std::string::npos);
  EXPECT_NE(header.find("//   markers  door.yaml  sha256 " + sha256("markers: []\n")), std::string::npos);
  EXPECT_EQ(header.find("machine"), std::string::npos);
}

TEST(EmitHeader, DrawsTheTree) {
  const auto outcome =
      compile_text(robot("<link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
                         "<joint name='ab' type='continuous'><parent link='a'/><child link='b'/></joint>"
                         "<joint name='bc' type='continuous'><parent link='b'/><child link='c'/></joint>"
                         "<joint name='ad' type='continuous'><parent link='a'/><child link='d'/></joint>"),
                   {}, test::with_points({"p=a:0,0,0", "q=c:0,0,0", "r=c:0,0,1", "s=d:0,0,0"}));
  EXPECT_NE(outcome.model->header.find("//   a  [p]\n"
                                       "//   |-- ab (continuous) --> b\n"
                                       "//   |   `-- bc (continuous) --> c  [q, r]\n"
                                       "//   `-- ad (continuous) --> d  [s]\n"),
            std::string::npos)
      << outcome.model->header;
}

TEST(EmitHeader, RepeatsTheOptionsBecauseTheyShapeTheTable) {
  ModelOptions options = test::with_points({"p=door:0,-1.5,0"});
  options.root = "door";
  options.freeze = {{"hinge", 0.25}};
  EXPECT_NE(compile_text(kDoor, {}, options)
                .model->header.find("//   options  --root door --freeze hinge=0.25 --poi p=door:0,-1.5,0\n"),
            std::string::npos);
}

TEST(EmitHeader, ShowsGearsAndHeldJoints) {
  const auto turns = [](const std::string& name, const std::string& child, const std::string& mimic = "") {
    return "<link name='" + child + "'/><joint name='" + name + "' type='continuous'><parent link='a'/><child link='" +
           child + "'/>" + mimic + "</joint>";
  };
  ModelOptions options = test::with_points({"p=b:0,0,0", "q=c:0,0,0", "r=d:0,0,0"});
  options.freeze = {{"latch", 0.5}};
  const auto outcome =
      compile_text(robot("<link name='a'/>" + turns("knob", "b") +
                         turns("gear", "c", "<mimic joint='knob' multiplier='-2' offset='.1'/>") + turns("latch", "d")),
                   {}, options);
  ASSERT_TRUE(outcome.model) << outcome.messages;
  for (const char* line :
       {"`-- gear (continuous, = -2 knob + 0.1) --> c  [q]", "leader ratio offset", "-1,     1,     0},",
        " 0,    -2,   0.1},", "FrozenRow, 1> kFrozen{{", "{\"latch\", 0.5},",
        "struct Joint {\n    enum : int { kKnob };\n  };", "struct Marker {\n    enum : int { kP, kQ, kR };\n  };"}) {
    EXPECT_NE(outcome.model->header.find(line), std::string::npos) << line << '\n' << outcome.model->header;
  }
}

TEST(EmitHeader, SaysThatThereIsNoStart) {
  const std::string header = compile_text(kDoor).model->header;
  EXPECT_NE(header.find("kHasQ0 = false;"), std::string::npos);
  EXPECT_NE(header.find("std::array<double, 8> kQ0{0, 0, 0, 1, 0, 0, 0, 0};"), std::string::npos);
}

TEST(EmitHeader, LetsNoNameLeaveItsLiteralOrItsComment) {
  Table table;
  table.robot = "r\"; int evil; \\ \n\xC3\xA9";
  table.root_link = "a\\\nint evil;";
  const std::string header = emit_header(table, "Model", {{"shape", "f\n\\", "0"}}, "--root a\\");
  EXPECT_NE(header.find(R"(kName = "r\"; int evil; \\ \012\303\251";)"), std::string::npos) << header;
  EXPECT_NE(header.find("//   a__int evil;\n"), std::string::npos) << header;
  EXPECT_EQ(header.find("\\\n"), std::string::npos) << "a comment runs on into the next line";
}

}  // namespace
}  // namespace articam::modelgen
