// articam-markers from outside: what it prints, what it writes, how it ends.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"

namespace {

namespace fs = std::filesystem;

using articam::test::Ended;

class MarkersProgram : public testing::Test {
 protected:
  MarkersProgram() { fs::create_directories(folder_); }
  ~MarkersProgram() override { fs::remove_all(folder_); }

  Ended markers(const std::string& arguments, const std::string& before = "") const {
    return articam::test::run("cd '" + folder_.string() + "' && " + before + ARTICAM_MARKERS " " + arguments);
  }

  std::string read(const char* name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  /// A door with one marker, and a joint that q0 counts only if it moves.
  void write_door(const std::string& marker, const std::string& rest = "") const {
    write("door.urdf",
          "<robot name='door'><link name='frame'/><link name='leaf'/><joint name='hinge' type='continuous'>"
          "<parent link='frame'/><child link='leaf'/></joint></robot>");
    write("door.yaml", "markers:\n  - {frame: leaf, " + marker + "}\n" + rest);
  }

  const fs::path folder_ = articam::test::own_folder();
};

constexpr const char* kOwn = "--urdf door.urdf --markers door.yaml -o door.pdf ";
constexpr const char* kDot = "type: dot, diameter_m: 0.02, polarity: light_on_dark";

TEST_F(MarkersProgram, WritesASheetOfAStaticModelAndSaysWhatToDoNext) {
  const Ended ended = markers("printer_drawer -o sheet.pdf");
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.text, "sheet.pdf\n6 markers, 2 pages of A4 portrait. Print at 100 %, then measure the ruler.\n");
  EXPECT_EQ(read("sheet.pdf").substr(0, 5), "%PDF-");
}

TEST_F(MarkersProgram, WritesOneSvgAPage) {
  EXPECT_EQ(markers("printer_drawer -o sheet.svg").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "sheet-1.svg") && fs::exists(folder_ / "sheet-2.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "sheet.svg"));
  EXPECT_EQ(markers("printer_drawer -o sheet.svg --paper A3").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "sheet.svg"));
}

TEST_F(MarkersProgram, WritesTheSameBytesTwiceAndInAnyLocale) {
  for (const char* format : {"pdf", "svg"}) {
    const std::string name = std::string{"mire."} + format;
    ASSERT_EQ(markers("mire -o " + name).exit_code, 0);
    const std::string first = read(name.c_str());
    ASSERT_EQ(markers("mire -o " + name, "LC_ALL=de_DE.UTF-8 ").exit_code, 0);
    EXPECT_EQ(read(name.c_str()), first);
  }
}

TEST_F(MarkersProgram, WritesNoDate) {
  if (articam::test::run("command -v pdfinfo").exit_code != 0) GTEST_SKIP() << "needs pdfinfo (poppler-utils)";
  const Ended ended = markers("mire -o sheet.pdf && pdfinfo sheet.pdf");
  EXPECT_NE(ended.text.find("Markers of mire"), std::string::npos) << ended.text;
  EXPECT_EQ(ended.text.find("Date"), std::string::npos) << ended.text;
}

TEST_F(MarkersProgram, TakesAModelOfOnesOwn) {
  write_door(kDot);
  const Ended ended = markers(std::string{kOwn} + "--paper LETTER --margin 15");
  EXPECT_EQ(ended.exit_code, 0) << ended.text;
  EXPECT_NE(ended.text.find("1 marker, 1 page of Letter portrait"), std::string::npos) << ended.text;
}

TEST_F(MarkersProgram, TakesTheOptionsThatAModelIsCompiledWith) {
  write_door(kDot, "q0: [0, 0, 1, 1, 0, 0, 0]\n");
  EXPECT_EQ(markers(kOwn).exit_code, 1);
  const Ended ended = markers(std::string{kOwn} + "--freeze hinge=0.5");
  EXPECT_EQ(ended.exit_code, 0) << ended.text;
}

TEST_F(MarkersProgram, WritesNothingWhenTheInputIsRefused) {
  write("door.pdf", "old");
  write_door("type: square");
  Ended ended = markers(kOwn);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.text.find("door.yaml:2: marker 1 type: 'square' is neither"), std::string::npos) << ended.text;
  write_door("type: dot, diameter_m: 0.2, polarity: light_on_dark");
  ended = markers(kOwn);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_EQ(ended.text,
            "articam-markers: marker 'leaf' needs 312 x 322 mm within the margins of A4: too large for every paper; "
            "check its diameter, it is in m\n");
  write("door.yaml", "markers: []\n");
  ended = markers(kOwn);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.text.find("articam-markers: 'door' has no markers to print\n"), std::string::npos) << ended.text;
  EXPECT_EQ(markers("--urdf absent.urdf --markers absent.yaml -o door.pdf").exit_code, 1);
  EXPECT_EQ(markers("mire -o absent/door.pdf").text,
            "articam-markers: absent/door.pdf: output: cannot be created: No such file or directory\n");
  EXPECT_EQ(read("door.pdf"), "old");
}

TEST_F(MarkersProgram, EndsWithTwoOnWrongUsage) {
  write_door(kDot);
  for (const char* arguments :
       {"", "mire", "-o s.pdf", "mire -o s.png", "mire -o s", "absent -o s.pdf", "mire mire -o s.pdf",
        "mire -o s.pdf --paper a5", "mire -o s.pdf --margin -1", "mire -o s.pdf --margin 51", "mire -o s.pdf --unknown",
        "mire -o s.pdf --root a", "--urdf door.urdf -o s.pdf", "--markers door.yaml -o s.pdf",
        "mire --urdf door.urdf --markers door.yaml -o s.pdf",
        "--urdf door.urdf --markers door.yaml -o s.pdf --freeze hinge"}) {
    EXPECT_EQ(markers(arguments).exit_code, 2) << arguments;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
}

TEST_F(MarkersProgram, TeachesWithHelpAndTellsItsVersion) {
  const Ended help = markers("--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.text.find("Examples"), std::string::npos);
  EXPECT_NE(help.text.find("Exit codes"), std::string::npos);
  EXPECT_EQ(markers("--version").exit_code, 0);
  EXPECT_NE(markers("--list").text.find("printer_drawer\n"), std::string::npos);
}

}  // namespace
