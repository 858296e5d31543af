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

  Ended run(const std::string& program_and_arguments) const {
    return articam::test::run("cd " + folder_.string() + " && " ARTICAM_BIN "/" + program_and_arguments);
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
  EXPECT_FALSE(fs::exists(folder_ / "e.csv.part"));
}

TEST_F(Programs, SimRefusesWhatItCannotUseAndSaysWhy) {
  expect("articam-sim", 2, {});
  expect("articam-sim --list", 0, {"paper"});
  expect("articam-sim no_such --out out", 2, {"no_such", "paper"});
  expect("articam-sim paper --seed x --out out", 2, {"--seed"});
  expect("articam-sim paper --mode fast --out out", 2, {"--mode"});
  expect("articam-sim paper --duration 2 --out frames/a.pgm/out", 1, {"frames/a.pgm/out"});
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Programs, DetectRefusesWhatIsNoFrame) {
  expect("articam-detect", 2, {});
  expect("articam-detect none.pgm", 1, {"none.pgm"});
  expect("articam-detect short.pgm", 1, {"short.pgm"});
  expect("articam-detect --type square frames/a.pgm", 2, {"--type"});
  expect("articam-detect --ring-ratio 1.5 frames/a.pgm", 2, {"--ring-ratio"});
  expect("articam-detect frames/a.pgm", 0, {"file,type,x_px,y_px,major_px,minor_px,angle_rad"});
}

}  // namespace
