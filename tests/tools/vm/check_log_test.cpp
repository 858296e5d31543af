#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"

// The judge of the virtual board, on consoles written here: nothing is emulated.
namespace articam {
namespace {

constexpr const char* kHeader = "frame,t_s,status,reason,matched,rms_px\r\n";

std::string row(int frame, double t_s, const char* status = "lost", const char* reason = "few_markers") {
  return std::to_string(frame) + "," + std::to_string(t_s) + "," + status + "," + reason + ",0,\r\n";
}

std::string console(const std::string& rows, int exit_code = 0) {
  return "[    0.1] a line of the kernel\r\nvm: starts 2.00\r\ncamera  vimc\r\n" + (kHeader + rows) +
         "vm: ended 9.00 with exit code " + std::to_string(exit_code) + "\r\n";
}

/// Three frames are wanted.
test::Ended judge(const std::string& log) {
  const std::string file = test::own_folder().string() + ".log";
  std::ofstream(file, std::ios::binary) << log;
  const test::Ended ended = test::run("awk -v wanted=3 -f '" ARTICAM_CHECK_LOG "' '" + file + "'");
  std::filesystem::remove(file);
  return ended;
}

void expect_wrong(const std::string& log, const std::string& why) {
  const test::Ended ended = judge(log);
  EXPECT_EQ(ended.exit_code, 1) << ended.text;
  EXPECT_NE(ended.text.find("wrong: " + why), std::string::npos) << ended.text;
}

const std::string kGood = row(4, 3.0) + row(5, 3.1) + row(7, 3.3, "initialising");

TEST(VmCheckLog, AcceptsRisingFramesWithOneOutputEachAndCountsTheOvertaken) {
  const test::Ended ended = judge(console(kGood));
  EXPECT_EQ(ended.exit_code, 0) << ended.text;
  EXPECT_NE(ended.text.find("3 frames"), std::string::npos) << ended.text;
  EXPECT_NE(ended.text.find("period 100.0 ms (100.0 to 100.0), 1 overtaken, 0 silent"), std::string::npos)
      << ended.text;
}

TEST(VmCheckLog, TakesATickWithoutAFrameForNoOutputOfAFrame) {
  const std::string silent = row(5, 3.2, "lost", "camera_stalled");
  EXPECT_EQ(judge(console(row(4, 3.0) + row(5, 3.1) + silent + row(6, 3.3))).exit_code, 0);
  expect_wrong(console(row(4, 3.0) + row(5, 3.1) + silent), "2 frames came, 3 were wanted");
}

TEST(VmCheckLog, FindsASecondOutputAndASequenceOrATimeThatDoesNotRise) {
  expect_wrong(console(kGood + row(7, 3.4)), "a second output for frame 7");
  expect_wrong(console(kGood + row(6, 3.4)), "frame 6 came after frame 7");
  expect_wrong(console(kGood + row(8, 3.3)), "frame 8 at 3.300000 s is not later");
}

TEST(VmCheckLog, FindsTimesThatAreNotOfTheBoardsMonotonicClockOrNoPeriodOfACamera) {
  expect_wrong(console(row(1, 1.9) + kGood), "frame 1 is older than the program");
  expect_wrong(console(kGood + row(8, 1.7e9)), "a frame is of the future");
  expect_wrong(console(row(1, 3.0) + row(2, 3.001) + row(3, 3.002)), "a frame every 0.001 s");
}

TEST(VmCheckLog, FindsAnEstimateWhereThereIsNothingToSee) {
  expect_wrong(console(kGood + row(8, 3.4, "tracking", "none")), "status tracking");
}

TEST(VmCheckLog, FindsABoardThatDidNotStartDidNotEndOrFailed) {
  expect_wrong("Kernel panic\r\n", "the board did not come as far as its program");
  expect_wrong("vm: starts 2.00\r\n" + (kHeader + kGood), "the program did not end in time");
  expect_wrong(console(kGood, 1), "the program ended with exit code 1");
}

}  // namespace
}  // namespace articam
