#include "hal/receiver/health.hpp"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/hal/receiver/receiver_fixture.hpp"
#include "tests/support/pseudo_terminal.hpp"

namespace {
std::atomic<int> failure_of_recvmsg{0};  ///< errno; 0: the system's own answer
}

/// Stands before the system's.
extern "C" ssize_t recvmsg(int descriptor, msghdr* message, int flags) {
  if (const int error = failure_of_recvmsg; error != 0) return errno = error, -1;
  return ::syscall(SYS_recvmsg, descriptor, message, flags);
}

namespace articam {
namespace {

using receiver::Health;
using receiver::Reading;
using test::comes;
using test::moving;
using test::ReceiverTest;

TEST_F(ReceiverTest, IsHealthyWhileItListensHoweverSilentTheBoardIs) {
  EXPECT_EQ(receiver_.health(), Health{});
  start();
  EXPECT_EQ(receiver_.health(), (Health{Health::State::listening, 0, 0}));
  send(moving(1));
  ASSERT_TRUE(hears(1));
  EXPECT_EQ(receiver_.health(), (Health{Health::State::listening, 0, 0}));
  receiver_.stop();
  EXPECT_EQ(receiver_.health().state, Health::State::stopped);
}

TEST_F(ReceiverTest, ASocketThatFailsIsOpenedAnewAndHeardAgain) {
  start();
  send(moving(1));
  ASSERT_TRUE(hears(1));
  failure_of_recvmsg = ENETDOWN;
  send(moving(2));
  ASSERT_TRUE(comes([&] { return receiver_.health().failures == 1; }));
  failure_of_recvmsg = 0;
  ASSERT_TRUE(comes([&] { return receiver_.health().state == Health::State::listening; }));
  send(moving(3));
  EXPECT_TRUE(hears(3));
}

/// A board on a serial line whose adapter can be unplugged: the path stays, what it leads to does not.
class SerialReceiverTest : public ReceiverTest {
 protected:
  void SetUp() override {
    plug_in();
    if (!board_->works()) GTEST_SKIP() << "no pseudo terminal here";
    options_.address = "serial://" + path_.string() + "?baud=115200";
    ASSERT_EQ(receiver_.start(options_), Status::ok) << receiver_.problem();
  }
  void TearDown() override { std::filesystem::remove(path_); }
  void plug_in() {
    board_.emplace();
    if (!board_->works()) return;
    std::filesystem::remove(path_);
    std::filesystem::create_symlink(board_->path(), path_);
  }
  void unplug() {
    std::filesystem::remove(path_);
    board_.reset();
  }
  void say(std::uint32_t number) { ASSERT_TRUE(board_->say(test::framed(test::packet_of(moving(number))))); }
  bool is(Health::State state) {
    return comes([&] { return receiver_.health().state == state; });
  }

  const std::filesystem::path path_{std::filesystem::temp_directory_path() /
                                    ("articam_line_" + std::to_string(::getpid()))};
  std::optional<test::PseudoTerminal> board_;
};

TEST_F(SerialReceiverTest, HearsABoardOnASerialLineThroughNoise) {
  for (const std::uint32_t number : {1u, 2u, 3u}) {
    ASSERT_TRUE(board_->say(test::Bytes{200, 1, 2, 0}));
    say(number);
  }
  ASSERT_TRUE(hears(3));
  ASSERT_TRUE(comes([&] { return receiver_.counters().estimates == 3; }));
  EXPECT_EQ(receiver_.counters().broken_frames, 3u);
  EXPECT_EQ(receiver_.counters().lost, 0u);
  const Reading reading = receiver_.newest();
  EXPECT_NEAR(reading.age_s, 0.02 + reading.silence_s, 1e-12);  // a rounding of numbers below 1
}

TEST_F(SerialReceiverTest, AnUnpluggedLineIsBrokenForAReasonAndHeardAgainOnceItIsBack) {
  say(1);
  ASSERT_TRUE(hears(1));
  unplug();
  ASSERT_TRUE(is(Health::State::broken));
  EXPECT_TRUE(comes([&] { return receiver_.health().error == ENOENT; })) << "EIO first, then there is no such file";
  EXPECT_EQ(receiver_.newest().estimate.number, 1u) << "the last one stays, and becomes stale";
  plug_in();
  ASSERT_TRUE(is(Health::State::listening));
  EXPECT_EQ(receiver_.health(), (Health{Health::State::listening, 0, 1}));
  say(2);
  EXPECT_TRUE(hears(2));
  EXPECT_EQ(receiver_.counters().sessions, 1u);
}

TEST_F(SerialReceiverTest, CanBeStoppedWhileItsLineIsGone) {
  unplug();
  ASSERT_TRUE(is(Health::State::broken));
  receiver_.stop();
  EXPECT_EQ(receiver_.health(), Health{});
  EXPECT_EQ(receiver_.start(options_), Status::io_error);
  EXPECT_NE(receiver_.problem().find(path_), std::string::npos) << receiver_.problem();
}

}  // namespace
}  // namespace articam
