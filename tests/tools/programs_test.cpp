// The programs from outside: what they print, what they write, how they end.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "static_models/registry.hpp"
#include "tests/support/hostile_models.hpp"
#include "tests/support/run_program.hpp"

namespace {

namespace fs = std::filesystem;

using articam::test::Ended;
using articam::test::run;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const std::string kDoor =
    "<robot name='kitchen door'><link name='frame'/><link name='door'/>"
    "<joint name='hinge\xC3\xA9' type='revolute'><parent link='frame'/><child link='door'/>"
    "<origin xyz='.25 .5 0' rpy='1 2 3'/><axis xyz='0 1 1'/><limit lower='-.5' upper='1.57'/></joint></robot>\n";

class ModelgenProgram : public testing::Test {
 protected:
  ModelgenProgram() { fs::create_directories(folder_); }
  ~ModelgenProgram() override { fs::remove_all(folder_); }

  /// Compiles a text, with further arguments.
  Ended compile(const std::string& urdf, const std::string& rest = "", const std::string& before = "") const {
    std::ofstream(folder_ / "m.urdf", std::ios::binary) << urdf;
    return run("cd " + folder_.string() + " && " + before + ARTICAM_MODELGEN + " --urdf m.urdf --name Door -o m.hpp " +
               rest);
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ModelgenProgram, WritesTheSameBytesTwiceAndInAnyLocale) {
  ASSERT_EQ(compile(kDoor).exit_code, 0);
  const std::string first = read(folder_ / "m.hpp");
  EXPECT_NE(first, "");
  ASSERT_EQ(compile(kDoor, "", "LC_ALL=de_DE.UTF-8 ").exit_code, 0);
  EXPECT_EQ(read(folder_ / "m.hpp"), first);
}

TEST_F(ModelgenProgram, WritesAHeaderThatEveryCompilerTakesAloneWithoutAWarning) {
  int compilers = 0;
  for (const char* rest : {"", "--poi p=door:0,0,1", "--root door --freeze hinge\xC3\xA9=0.5 --poi p=frame:0,0,1"}) {
    ASSERT_EQ(compile(kDoor, rest).exit_code, 0);
    for (const std::string compiler :
         {"g++", "clang++", "aarch64-linux-gnu-g++", "arm-linux-gnueabihf-g++", "arm-none-eabi-g++"}) {
      if (run("command -v " + compiler).exit_code != 0) continue;
      ++compilers;
      const Ended ended = run("echo '#include \"m.hpp\"' | " + compiler +
                              " -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only"
                              " -I " ARTICAM_SOURCE_DIR " -I " +
                              folder_.string() + " -x c++ -");
      EXPECT_EQ(ended.exit_code, 0) << compiler << ' ' << rest << '\n' << ended.text;
    }
  }
  if (compilers == 0) GTEST_SKIP() << "no compiler on the path";
}

TEST_F(ModelgenProgram, WritesNothingWhenTheInputIsRefused) {
  std::ofstream(folder_ / "m.hpp") << "old";
  const Ended ended = compile("<robot name='r'>\n<link name='a'/>\n<link name='a'/></robot>");
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_EQ(ended.text.substr(0, 19), "m.urdf:3: link 'a':");
  EXPECT_EQ(read(folder_ / "m.hpp"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2) << "a temporary file stayed behind";
}

TEST_F(ModelgenProgram, TellsWhyItCannotReadOrWrite) {
  EXPECT_EQ(compile(kDoor, "--markers absent.yaml").text,
            "absent.yaml: file: cannot be opened: No such file or directory\n");
  const Ended ended = compile(kDoor, "; " ARTICAM_MODELGEN " --urdf m.urdf --name Door -o absent/m.hpp");
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.text.find("absent/m.hpp: output: cannot be created: No such file"), std::string::npos) << ended.text;
}

TEST_F(ModelgenProgram, WritesNoHeaderWithoutItsReport) {
  std::ofstream(folder_ / "m.hpp") << "old";
  const Ended ended = compile(kDoor, "--report absent/r.txt");
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.text.find("absent/r.txt: output: cannot be created"), std::string::npos) << ended.text;
  EXPECT_EQ(read(folder_ / "m.hpp"), "old");
}

TEST_F(ModelgenProgram, TellsWhatIsWrongInAllOfItsFilesInOneRun) {
  std::ofstream(folder_ / "c.yaml") << "image_width: none\n";
  const Ended ended = compile("<robot name='r'>\n<link/></robot>", "--report - --report-camera c.yaml");
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.text.find("c.yaml:1: image_width"), std::string::npos) << ended.text;
  EXPECT_NE(ended.text.find("m.urdf:2: link"), std::string::npos) << ended.text;
}

TEST_F(ModelgenProgram, EndsWithTwoOnWrongUsage) {
  for (const char* rest :
       {"--name other", "--report-noise 0 --report r.txt", "--report-noise 1", "--freeze hinge", "--freeze hinge=x",
        "--poi p=door", "--poi p=door:1,2", "--poi =door:1,2,3", "--poi 'p=door:1, 2,3'", "--unknown", "extra"}) {
    EXPECT_EQ(compile(kDoor, rest).exit_code, 2) << rest;
  }
  EXPECT_NE(compile(kDoor, "--marker m.yaml").text.find("'--marker' is not expected"), std::string::npos);
  EXPECT_NE(run(ARTICAM_PICTURE " --udrf m.urdf").text.find("'--udrf' is not expected"), std::string::npos);
  EXPECT_EQ(run(ARTICAM_MODELGEN).exit_code, 2);
  std::ofstream(folder_ / "m.urdf") << kDoor;
  EXPECT_EQ(run("cd " + folder_.string() + " && " ARTICAM_MODELGEN " --urdf m.urdf --name Door -o ./m.urdf").exit_code,
            2);
  EXPECT_EQ(read(folder_ / "m.urdf"), kDoor);
}

TEST_F(ModelgenProgram, ReportsAsTextOrAsJsonWithoutAHeaderIfNoneIsAsked) {
  std::ofstream(folder_ / "m.urdf", std::ios::binary) << kDoor;
  std::ofstream(folder_ / "m.yaml")
      << "markers:\n  - {frame: door, type: dot, diameter_m: 0.05, polarity: dark_on_light}\n";
  const std::string base = "cd " + folder_.string() + " && " + ARTICAM_MODELGEN + " --urdf m.urdf --markers m.yaml ";
  EXPECT_EQ(run(base + "--report r.txt --report-range 0.4:0.9 --report-noise 0.05").exit_code, 0);
  EXPECT_NE(read(folder_ / "r.txt").find("Range 0.40 to 0.90 m"), std::string::npos);
  EXPECT_NE(read(folder_ / "r.txt").find("hinge\xC3\xA9"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "m.hpp"));
  EXPECT_EQ(run(base + "--report r.json --name Door -o m.hpp").exit_code, 0);
  EXPECT_EQ(read(folder_ / "r.json").substr(0, 14), "{\n  \"schema\": ");
  EXPECT_TRUE(fs::exists(folder_ / "m.hpp"));
  for (const std::string range : {"1", "2:1", "0:1", "a:b", "1:", ":1", "1:2:3"}) {
    const Ended ended = run(base + "--report no.txt --report-range " + range);
    EXPECT_EQ(ended.exit_code, 2) << range;
    EXPECT_NE(ended.text.find("--report-range: '" + range + "' is not MIN:MAX in m, between 0.01 and 100\n"),
              std::string::npos);
  }
  EXPECT_FALSE(fs::exists(folder_ / "no.txt"));
  EXPECT_EQ(run(base + "--report -").text.find(": what its marks will tell"), 12u);  // behind 'kitchen door'
  EXPECT_EQ(run(base + "--name Door -o same.txt --report ./same.txt").exit_code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "same.txt"));
}

/// Whether a limit of its address space is one of the program's own.
bool modelgen_can_be_limited() {
#ifdef __SANITIZE_ADDRESS__
  return false;
#else
  return read(ARTICAM_MODELGEN).substr(0, 2) != "#!";  // a script that calls the emulator
#endif
}

TEST_F(ModelgenProgram, RefusesHostileFilesWithin64Mebibytes) {
  if (!modelgen_can_be_limited()) GTEST_SKIP() << "the sanitizer or the emulator reserves more than that for itself";
  for (const articam::test::HostileModel& model : articam::test::hostile_models()) {
    std::ofstream(folder_ / "m.yaml", std::ios::binary) << model.markers;
    const Ended ended = compile(model.urdf, model.markers.empty() ? "" : "--markers m.yaml", "ulimit -v 65536; ");
    EXPECT_EQ(ended.exit_code, 1) << model.name << ": " << ended.text;
    EXPECT_FALSE(fs::exists(folder_ / "m.hpp")) << model.name;
  }
}

TEST_F(ModelgenProgram, TakesAFlatOf117LinksWithin64Mebibytes) {
  if (!modelgen_can_be_limited()) GTEST_SKIP() << "the sanitizer or the emulator reserves more than that for itself";
  const std::string urdf = read(fs::path(ARTICAM_URDF_CORPUS) / "code-iai__iai_maps__apartment.urdf");
  if (urdf.empty()) GTEST_SKIP() << "no URDF corpus at ../shared/urdf_corpus";
  const Ended ended = compile(urdf, "--poi p=coffee_table_drawer:0,0,0", "ulimit -v 65536; ");
  EXPECT_EQ(ended.exit_code, 0) << ended.text;
  EXPECT_TRUE(fs::exists(folder_ / "m.hpp"));
}

TEST(Programs, TeachWithHelpAndTellTheirVersion) {
  for (const std::string program : {ARTICAM_MODELGEN, ARTICAM_PICTURE, ARTICAM_PROBE}) {
    const Ended help = run(program + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.text.find("Example"), std::string::npos);
    EXPECT_NE(help.text.find("Exit codes"), std::string::npos);
    EXPECT_EQ(run(program + " --version").exit_code, 0);
  }
}

TEST(PictureProgram, DrawsAModelAndRefusesAFileThatIsNot) {
  const std::string door = ARTICAM_SOURCE_DIR "/static_models/door/door";
  const fs::path folder = fs::path(testing::TempDir()) / "picture";
  fs::create_directories(folder);
  const std::string rest = " --markers " + door +
                           ".markers.yaml --camera " ARTICAM_SOURCE_DIR
                           "/static_models/cameras/xtion_vga.yaml --width 32 -o " +
                           (folder / "door.png").string();
  EXPECT_EQ(run(ARTICAM_PICTURE " --urdf " + door + ".markers.yaml" + rest).exit_code, 1);
  EXPECT_FALSE(fs::exists(folder / "door.png"));
  const Ended drawn = run(ARTICAM_PICTURE " --urdf " + door + ".urdf" + rest);
  EXPECT_EQ(drawn.exit_code, 0) << drawn.text;
  EXPECT_EQ(drawn.text, "");
  EXPECT_EQ(read(folder / "door.png").substr(1, 3), "PNG");
  EXPECT_EQ(run(ARTICAM_PICTURE " --urdf " + door + ".urdf").exit_code, 2);
  fs::remove_all(folder);
}

TEST(ProbeProgram, AnswersOneBlockALine) {
  EXPECT_EQ(run("printf '\\n\\n' | " ARTICAM_PROBE " mire | grep -c '^end$'").text, "2\n");
  EXPECT_EQ(run("echo 0.08 0.12 | " ARTICAM_PROBE " printer_drawer | head -1").text,
            "joints drawer_slide marker_distance\n");
  EXPECT_EQ(run("printf '' | " ARTICAM_PROBE " mire").text, "joints\n");
}

TEST(ProbeProgram, RefusesALineThatIsNotASetOfJointValues) {
  for (const char* line : {"", "1", "1 2 3", "1 x", "1 nan", "1,2"}) {
    const Ended ended = run(std::string("echo '") + line + "' | " ARTICAM_PROBE " printer_drawer");
    EXPECT_EQ(ended.exit_code, 1) << line;
    EXPECT_NE(ended.text.find("stdin:1: joints: expected 2 finite numbers"), std::string::npos) << ended.text;
  }
}

TEST(ProbeProgram, EndsWithTwoOnAModelThatIsNotThere) {
  EXPECT_EQ(run(ARTICAM_PROBE " absent < /dev/null").exit_code, 2);
  EXPECT_EQ(run(ARTICAM_PROBE " < /dev/null").exit_code, 2);
  std::string names;
  for (const auto name : articam::models::kStaticModelNames) names.append(name).append("\n");
  EXPECT_EQ(run(ARTICAM_PROBE " --list").text, names);
}

}  // namespace
