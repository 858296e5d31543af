/// @file  articam-replay --identify from outside, over rendered frames.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "static_models/cameras/xtion_vga.hpp"
#include "tests/programs/orbit.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"

namespace articam {
namespace {

namespace fs = std::filesystem;

class ReplayIdentify : public testing::Test {
 protected:
  ReplayIdentify() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~ReplayIdentify() override { fs::remove_all(folder_); }

  void expect(const std::string& arguments, int exit_code, std::initializer_list<const char*> words) const {
    const auto ended = test::run("cd " ARTICAM_SOURCE_DIR " && " ARTICAM_BIN
                                 "/articam-replay printer_drawer"
                                 " --camera static_models/cameras/xtion_vga.yaml " +
                                 arguments);
    EXPECT_EQ(ended.exit_code, exit_code) << arguments << '\n' << ended.text;
    for (const char* word : words) EXPECT_NE(ended.text.find(word), std::string::npos) << word << '\n' << ended.text;
  }
  std::string in_folder(const char* name) const { return (folder_ / name).string(); }

  const fs::path folder_ = test::own_folder();
};

TEST_F(ReplayIdentify, FindsADisplacedMarkerAnUnknownDistanceAndAWrongFocalLength) {
  test::Orbit orbit{cameras::kXtionVga, {0.003, 0, 0}};
  orbit.camera.fx_px *= 1.01, orbit.camera.fy_px *= 1.01;
  ASSERT_EQ(test::draw(orbit, folder_ / "frames"), "");
  const std::string urdf = in_folder("found.urdf"), yaml = in_folder("found.yaml"), header = in_folder("found.hpp");
  expect("--frames " + in_folder("frames") + " -o " + in_folder("est.csv") + " --identify " + urdf + " --identify " +
             yaml + " --virtual marker_distance",
         0, {"marker_distance      120.0", "displaced", "too short", "calibrate again"});

  const auto compiled =
      test::run(ARTICAM_BIN "/articam-modelgen --name Found --urdf " + urdf + " --markers " + yaml + " -o " + header);
  EXPECT_EQ(compiled.exit_code, 0) << compiled.text;
  std::ifstream file(header);
  const std::string table{std::istreambuf_iterator<char>{file}, {}};
  constexpr std::string_view kRow = "\"base_marker_1\",   ring, -1,  {";
  const auto row = table.find(kRow);
  ASSERT_NE(row, std::string::npos) << table;
  EXPECT_NEAR(std::stod(table.substr(row + kRow.size())), 0.163, 0.05e-3);
  EXPECT_EQ(table.find("\"marker_distance\""), std::string::npos) << table;
}

/// The numbers that follow the first `word`; none where it is missing.
std::vector<double> numbers_after(const std::string& text, const std::string& word) {
  const auto at = text.find(word);
  if (at == std::string::npos) return {};
  std::istringstream rest{text.substr(at + word.size())};
  std::vector<double> numbers;
  for (double number; rest >> number;) numbers.push_back(number);
  return numbers;
}

TEST_F(ReplayIdentify, FindsTheSameFromWhatABoardRecorded) {
  ASSERT_EQ(test::draw(test::Orbit{cameras::kXtionVga, {0.003, 0, 0}}, folder_ / "frames"), "");
  const auto board =
      test::run("cd " + folder_.string() +
                " && timeout 60 " ARTICAM_BIN
                "/articam-board --priority 0 --rate 30 --frames 200 --camera replay:frames --link stdout "
                "--record run.rec 2>log >board.csv");
  ASSERT_EQ(board.exit_code, 0) << board.text;
  const auto ended =
      test::run("cd " ARTICAM_SOURCE_DIR " && " ARTICAM_BIN "/articam-replay printer_drawer --recording " +
                in_folder("run.rec") + " -o " + in_folder("est.csv") + " --virtual marker_distance" + " --identify " +
                in_folder("found.yaml") + " --identify " + in_folder("found.urdf"));
  EXPECT_EQ(ended.exit_code, 0) << ended.text;
  EXPECT_NE(ended.text.find("identified from 200 moments"), std::string::npos) << ended.text;
  constexpr double kWithin_mm = 0.03;  // it owns to deviations of 0.002 to 0.008 mm
  const auto distance_mm = numbers_after(ended.text, "marker_distance");
  ASSERT_FALSE(distance_mm.empty()) << ended.text;
  EXPECT_NEAR(distance_mm[0], 120, kWithin_mm);
  const auto moved_mm = numbers_after(ended.text, "base_marker_1");
  ASSERT_GE(moved_mm.size(), 3u) << ended.text;
  EXPECT_NEAR(moved_mm[0], 3, kWithin_mm);
  EXPECT_NEAR(moved_mm[1], 0, kWithin_mm);
  EXPECT_NEAR(moved_mm[2], 0, kWithin_mm);
  EXPECT_NE(ended.text.find("displaced"), std::string::npos) << ended.text;
  EXPECT_TRUE(fs::exists(in_folder("found.yaml")) && fs::exists(in_folder("found.urdf")));
}

TEST_F(ReplayIdentify, RefusesWhatItCannotUseAndWritesNothing) {
  const std::string common = "--frames " + in_folder("frames") + " -o " + in_folder("est.csv");
  test::Orbit orbit{cameras::kXtionVga};
  orbit.num_frames = 4;
  ASSERT_EQ(test::draw(orbit, folder_ / "frames"), "");
  const std::string urdf = " --identify " + in_folder("a.urdf");
  expect(common + " --virtual marker_distance", 2, {"--identify"});
  expect(common + " --identify a.txt", 2, {"a.txt", "FILE.urdf"});
  expect(common + urdf + " --virtual drawer", 2, {"drawer_slide, marker_distance"});
  expect(common + urdf + " --urdf none.urdf", 1, {"none.urdf"});
  expect(common + urdf + " --urdf static_models/door/door.urdf", 1, {"base_marker_0"});
  expect(common + urdf, 1, {"frames have an estimate"});
  EXPECT_FALSE(fs::exists(in_folder("a.urdf")));
}

}  // namespace
}  // namespace articam
