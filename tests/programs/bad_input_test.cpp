/// @file  Programs that meet an image or a world: wrong use, bad input, and that nothing half-written stays behind.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"

namespace {

namespace fs = std::filesystem;
using articam::test::Ended;

class Programs : public testing::Test {
 protected:
  Programs() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "frames");
    std::ofstream(folder_ / "frames/a.pgm", std::ios::binary) << "P5 4 2 255\n12345678";
    std::ofstream(folder_ / "short.pgm", std::ios::binary) << "P5 640 480 255\nabc";
    std::ofstream(folder_ / "bad.yaml") << "image_width: 640\nimage_height: nan\n";
  }
  ~Programs() override { fs::remove_all(folder_); }

  Ended run_in_shell(const std::string& command) const {
    return articam::test::run("cd " + folder_.string() + " && " + command);
  }
  Ended run(const std::string& program_and_arguments) const {
    return run_in_shell(ARTICAM_BIN "/" + program_and_arguments);
  }
  /// frame.pgm, of the size of the camera mire_384x288: nothing is to be seen in it.
  void write_empty_frame() const {
    std::ofstream(folder_ / "frame.pgm", std::ios::binary) << "P5 384 288 255\n" << std::string(384 * 288, '\x40');
  }
  /// Names of temporary files that stayed behind.
  std::string leftovers() const {
    std::string names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name.find(".part") != std::string::npos) names += name + ' ';
    }
    return names;
  }
  /// Ends with that code, and says each of these words.
  void expect(const std::string& command, int exit_code, std::initializer_list<const char*> words) const {
    const Ended ended = run(command);
    EXPECT_EQ(ended.exit_code, exit_code) << command << '\n' << ended.text;
    for (const char* word : words) EXPECT_NE(ended.text.find(word), std::string::npos) << command << '\n' << ended.text;
  }

  const fs::path folder_ = articam::test::own_folder();
};

TEST_F(Programs, TeachTheirUseAndNameTheirVersion) {
  for (const std::string program : {"articam-replay", "articam-sim", "articam-detect"}) {
    expect(program + " --help", 0, {"Usage", "xample", "--version"});
    expect(program + " --version", 0, {"0.1.0"});
    expect(program + " --no-such-option", 2, {"--help"});
  }
}

TEST_F(Programs, ReplayRefusesWhatItCannotUseAndSaysWhy) {
  const std::string camera = " --camera " ARTICAM_CAMERAS "/mire_384x288.yaml ";
  expect("articam-replay", 2, {"required"});
  expect("articam-replay mire --frames frames -o e.csv", 2, {"--camera is required"});
  expect("articam-replay --list", 0, {"printer_drawer", "mire_distance"});
  expect("articam-replay no_such" + camera + "--frames frames -o e.csv", 2, {"no_such", "printer_drawer"});
  expect("articam-replay mire" + camera + "--frames nothing_here -o e.csv", 1, {"nothing_here"});
  expect("articam-replay mire --camera bad.yaml --frames frames -o e.csv", 1, {"bad.yaml", "image_height"});
  expect("articam-replay mire --camera none.yaml --frames frames -o e.csv", 1, {"none.yaml"});
  expect("articam-replay mire" + camera + "--frames frames --q0 '1 2 3' -o e.csv", 1, {"--q0", "expected 7 numbers"});
  expect("articam-replay mire" + camera + "--frames frames --q0 '0 0 1 0 0 0 0' -o e.csv", 1, {"quaternion"});
  expect("articam-replay mire" + camera + "--frames short.pgm -o e.csv", 1, {"short.pgm"});
  expect("articam-replay mire" + camera + "--frames frames --fps -3 -o e.csv", 2, {"--fps"});
  expect("articam-replay mire" + camera + "--frames frames --mode fast -o e.csv", 2, {"--mode"});
  expect("articam-replay mire" + camera + "--frames frames -o no/such/folder/e.csv", 1, {"no/such/folder/e.csv"});
  expect("articam-replay mire" + camera + "--frames frames -o e.csv", 1, {"a.pgm: is 4 x 2 pixels", "384 x 288"});
  EXPECT_FALSE(fs::exists(folder_ / "e.csv"));
  EXPECT_EQ(leftovers(), "");
}

TEST_F(Programs, ReplayRefusesNumbersThatNoCameraAndNoStartHas) {
  const std::string job = " --camera " ARTICAM_CAMERAS "/mire_384x288.yaml --frames frames -o e.csv --q0 ";
  expect("articam-replay mire" + job + "'0 0 1e300 1 0 0 0'", 1, {"--q0", "beyond 1e+06"});
  expect("articam-replay mire" + job + "'0 0 -0.5 1 0 0 0'", 1, {"--q0", "not in front of the camera"});
  std::ofstream(folder_ / "long.yaml")
      << "image_width: 640\nimage_height: 480\n"
         "camera_matrix: {rows: 3, cols: 3, data: [1e300, 0, 319.5, 0, 525, 239.5, 0, 0, 1]}\n"
         "distortion_model: plumb_bob\n"
         "distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}\n";
  expect("articam-replay mire --camera long.yaml --frames frames -o e.csv", 1, {"long.yaml:3", "focal length"});
  EXPECT_EQ(leftovers(), "");
}

TEST_F(Programs, ReplayWritesOverPlainFilesOnly) {
  const std::string job = "articam-replay mire --camera " ARTICAM_CAMERAS "/mire_384x288.yaml --frames frame.pgm -o ";
  write_empty_frame();
  fs::create_directories(folder_ / "taken");
  fs::create_symlink("taken", folder_ / "link");
  for (const char* target : {"taken", "link", "/dev/null"}) {
    expect(job + target, 1, {target, "only a plain file is replaced"});
  }
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(leftovers(), "");
}

TEST_F(Programs, ReplayFailsWhereItsSummaryOrItsRowsCannotBeWritten) {
  const std::string job = "articam-replay mire --camera " ARTICAM_CAMERAS "/mire_384x288.yaml --frames frame.pgm ";
  write_empty_frame();
  expect(job + "-o e.csv", 0, {"frames       1"});
  expect(job + "-o e.csv > /dev/full", 1, {"standard output: No space left"});
  // dash and bash count in blocks of 512 or 1024 bytes: no block at all means the same to both.
  EXPECT_EQ(run_in_shell("ulimit -f 0; trap '' XFSZ; " ARTICAM_BIN "/" + job + "-o f.csv").exit_code, 1);
  EXPECT_FALSE(fs::exists(folder_ / "f.csv"));
  EXPECT_EQ(leftovers(), "");
}

TEST_F(Programs, SimRefusesWhatItCannotUseAndSaysWhy) {
  expect("articam-sim", 2, {});
  expect("articam-sim --list", 0, {"paper"});
  expect("articam-sim no_such --out out", 2, {"no_such", "paper"});
  expect("articam-sim paper --seed x --out out", 2, {"--seed"});
  expect("articam-sim paper --mode fast --out out", 2, {"--mode"});
  expect("articam-sim drawer --mode truth --out out", 2, {"drawer has no robot"});
  expect("articam-sim soak --compare --out out", 2, {"soak has no robot"});
  expect("articam-sim paper --level features --frames-out out --out out", 2, {"--frames-out"});
  expect("articam-sim paper --duration 2 --out frames/a.pgm/out", 1, {"frames/a.pgm/out"});
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Programs, DetectRefusesWhatIsNoFrame) {
  expect("articam-detect", 2, {});
  expect("articam-detect none.pgm", 1, {"none.pgm"});
  expect("articam-detect short.pgm", 1, {"short.pgm"});
  expect("articam-detect --type square frames/a.pgm", 2, {"--type"});
  expect("articam-detect --ring-ratio 1.5 frames/a.pgm", 2, {"--ring-ratio"});
  expect("articam-detect --overlay short.pgm frames/a.pgm", 1, {"short.pgm"});
  expect("articam-detect frames/a.pgm", 0, {"file,type,x_px,y_px,major_px,minor_px,angle_rad"});
}

}  // namespace
