/// @file  The board's program from outside: recorded frames in, estimates out, as its service manager sees it.

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"

namespace {

namespace fs = std::filesystem;
using articam::test::Ended;

/// The frames of two seconds of the moving drawer, rendered once for all tests.
const fs::path& frames() {
  static const fs::path folder = [] {
    const fs::path here = fs::path(testing::TempDir()) / ("articam.board_frames." + std::to_string(::getpid()));
    const Ended ended = articam::test::run("mkdir -p " + (here / "out").string() +
                                           " && " ARTICAM_BIN "/articam-sim paper --duration 2 --frames-out " +
                                           here.string() + " --out " + (here / "out").string());
    EXPECT_EQ(ended.exit_code, 0) << ended.text;
    return here;
  }();
  return folder;
}
class RemoveFrames : public testing::Environment {
  void TearDown() override { fs::remove_all(frames()); }
};
const auto* const kRemoveFrames = testing::AddGlobalTestEnvironment(new RemoveFrames);

class Board : public testing::Test {
 protected:
  Board() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Board() override { fs::remove_all(folder_); }

  Ended run(const std::string& arguments, const std::string& before = {}) const {
    return articam::test::run("cd " + folder_.string() + " && " + before +
                              " timeout 60 " ARTICAM_BIN "/articam-board --priority 0 " + arguments);
  }
  std::string replayed(const std::string& more) const { return "--camera replay:" + frames().string() + " " + more; }
  /// Without the time, which begins at the start of the machine for the one and at 0 for the other.
  std::string rows_without_time(const std::string& file) const {
    return articam::test::run("cut -d, -f1,3- " + (folder_ / file).string()).text;
  }

  fs::path folder_ = articam::test::own_folder();
};

TEST_F(Board, GivesTheEstimatesOfAReplayBitForBitAlsoWhereTheFramesBeginAnew) {
  const Ended board = run(replayed("--rate 60 --frames 90 --link stdout 2>log >board.csv"));
  ASSERT_EQ(board.exit_code, 0) << board.text;
  const Ended replay = articam::test::run("cd " + folder_.string() +
                                          " && " ARTICAM_BIN "/articam-replay printer_drawer --camera " ARTICAM_CAMERAS
                                          "/xtion_vga.yaml --frames " +
                                          frames().string() + " --repeat 2 --max-frames 90 --fps 60 -o replay.csv");
  ASSERT_EQ(replay.exit_code, 0) << replay.text;
  const std::string rows = rows_without_time("board.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 91);
  EXPECT_TRUE(rows == rows_without_time("replay.csv"));
}

TEST_F(Board, IsReproducedBitForBitFromItsRecordingWhichItsFramesConfirm) {
  const Ended board = run(replayed(
      "--rate 60 --frames 60 --link stdout --record run.rec --record-frames run.frames --record-seconds 0.5 2>log "
      ">board.csv"));
  ASSERT_EQ(board.exit_code, 0) << board.text;
  const Ended replay = articam::test::run("cd " + folder_.string() +
                                          " && " ARTICAM_BIN
                                          "/articam-replay printer_drawer --recording run.rec --recorded-frames "
                                          "run.frames -o replay.csv && cmp board.csv replay.csv");
  EXPECT_EQ(replay.exit_code, 0) << replay.text;
  EXPECT_NE(replay.text.find("looked at    31 frames again, 0 seen otherwise"), std::string::npos) << replay.text;
}

TEST_F(Board, TellsAnotherModelsRecordingFromItsOwn) {
  ASSERT_EQ(run(replayed("--rate 60 --frames 3 --link stdout --record run.rec 2>log >board.csv")).exit_code, 0);
  const Ended replay = articam::test::run("cd " + folder_.string() +
                                          " && " ARTICAM_BIN "/articam-replay mire --recording run.rec -o replay.csv");
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_NE(replay.text.find("another model, 'printer_drawer'"), std::string::npos) << replay.text;
  EXPECT_FALSE(fs::exists(folder_ / "replay.csv"));
  const Ended both = articam::test::run("cd " + folder_.string() +
                                        " && " ARTICAM_BIN
                                        "/articam-replay printer_drawer --recording run.rec --fps 30 -o replay.csv");
  EXPECT_EQ(both.exit_code, 2) << "what the recording says is not to be said otherwise";
}

TEST_F(Board, SaysWhatItDidAndThatItsMemoryStoodStill) {
  const Ended board = run(replayed("--rate 60 --frames 90 --link udp://127.0.0.1:47999"));
  EXPECT_EQ(board.exit_code, 0);
  EXPECT_NE(board.text.find("total  90 frames"), std::string::npos) << board.text;
  EXPECT_NE(board.text.find("heap growth 0 bytes"), std::string::npos) << board.text;
  if (board.text.find("memory is not locked") != std::string::npos) GTEST_SKIP() << "memory cannot be locked here";
#ifndef ARTICAM_EMULATED  // an emulator translates as it goes, and faults for itself
  EXPECT_NE(board.text.find("page faults 0 "), std::string::npos) << board.text;
#endif
}

TEST_F(Board, EndsWithAClearWordWithoutACamera) {
  for (const char* const camera : {"v4l2:/dev/video_none", "replay:no_such_folder", "libcamera:no_such_camera"}) {
    const Ended board = run(std::string("--link stdout --camera ") + camera);
    EXPECT_EQ(board.exit_code, 1) << camera;
    EXPECT_NE(board.text.find("does not start"), std::string::npos) << board.text;
  }
}

TEST_F(Board, RefusesAStartAndAKeyThatCannotBe) {
  const Ended behind = run(replayed("--link stdout --q0 '0 0 -1 1 0 0 0 0 0'"));
  EXPECT_EQ(behind.exit_code, 1);
  EXPECT_NE(behind.text.find("pz is not positive"), std::string::npos) << behind.text;
  std::ofstream(folder_ / "key") << "too short";
  EXPECT_EQ(run(replayed("--link udp://127.0.0.1 --key key --counter counter")).exit_code, 1);
  EXPECT_EQ(run("--camera usb").exit_code, 2);
}

TEST_F(Board, StopsCleanlyWhenItIsAskedTo) {
  // Asked once it has written a row; a recording that was not closed would be longer than its ticks.
  const Ended board = articam::test::run(
      "cd " + folder_.string() + "; touch board.csv; " ARTICAM_BIN "/articam-board --priority 0 " +
      replayed("--rate 60 --link stdout --record run.rec 2>log >board.csv & board=$!; "
               "while [ $(wc -l <board.csv) -lt 5 ]; do sleep 0.05; done; kill -TERM $board; wait $board"));
  EXPECT_EQ(board.exit_code, 0) << board.text;
  EXPECT_NE(articam::test::run("cat " + (folder_ / "log").string()).text.find("total"), std::string::npos);
  EXPECT_LT(fs::file_size(folder_ / "run.rec"), 1u << 20);
}

TEST_F(Board, TellsItsServiceManagerWhenItIsReadyAliveAndStopping) {
  const std::string path = (folder_ / "notify").string();
  const int ear = ::socket(AF_UNIX, SOCK_DGRAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  ASSERT_LT(path.size(), sizeof address.sun_path);
  path.copy(address.sun_path, path.size());
  ASSERT_EQ(::bind(ear, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  // Read while it runs: what is told to a manager that does not listen waits for it.
  std::string told;
  std::thread listener{[ear, &told] {
    char word[64];
    while (!told.ends_with("STOPPING=1 ")) {
      const ssize_t n = ::recv(ear, word, sizeof word, 0);
      if (n <= 0) return;
      told.append(word, static_cast<std::size_t>(n)) += ' ';
    }
  }};
  const Ended board = run(replayed("--rate 60 --frames 60 --link stdout 2>log >board.csv"),
                          "NOTIFY_SOCKET=" + path + " WATCHDOG_USEC=400000");
  EXPECT_EQ(board.exit_code, 0) << board.text;
  ::shutdown(ear, SHUT_RD);
  listener.join();
  ::close(ear);
  EXPECT_TRUE(told.starts_with("READY=1 WATCHDOG=1 ")) << told;
  EXPECT_TRUE(told.ends_with("WATCHDOG=1 STOPPING=1 ")) << told;
  // One second of life, a limit of 0.4 s: fed each quarter of it, the first time included.
  EXPECT_GE(std::count(told.begin(), told.end(), 'W'), 5) << told;
}

TEST(BoardService, IsAUnitThatItsManagerAccepts) {
  if (articam::test::run("command -v systemd-analyze").exit_code != 0)
    GTEST_SKIP() << "systemd-analyze is not installed";
  const Ended verified = articam::test::run("systemd-analyze verify " ARTICAM_SERVICE);
  // It may complain of nothing but of the program, which is not installed here.
  for (std::size_t begin = 0, end = 0; begin < verified.text.size(); begin = end + 1) {
    end = std::min(verified.text.find('\n', begin), verified.text.size());
    const std::string line = verified.text.substr(begin, end - begin);
    EXPECT_NE(line.find("articam-board is not executable"), std::string::npos) << line;
  }
}

}  // namespace
