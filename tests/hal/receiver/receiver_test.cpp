#include "hal/receiver/receiver.hpp"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "hal/wire/message_reader.hpp"
#include "tests/support/heap_trap.hpp"
#include "tests/support/pseudo_terminal.hpp"
#include "tests/support/udp_ear.hpp"
#include "tests/support/wire_messages.hpp"

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

using receiver::Freshness;
using receiver::Health;
using receiver::Reading;
using receiver::Receiver;

std::uint16_t free_port() { return test::UdpEar{}.port(); }

/// Captured 20 ms before it was sent; the first joint moves at 1 m/s.
wire::EstimateMessage moving(std::uint32_t number) {
  test::Random random{51};
  wire::EstimateMessage m = test::random_estimate(random);
  m.session = 1, m.number = number, m.model_hash = 9;
  m.t_capture = {123'000'000'000}, m.t_send = {123'020'000'000};  // the board's clock, far from ours
  m.status = tracker::TrackingStatus::tracking;
  m.joints[0] = 0.1, m.velocity[6] = 1;
  return m;
}

/// Waits up to 5 s for a state that must come; the law is in the state, not in the time.
template <class Condition>
bool comes(Condition condition) {
  for (int k = 0; k < 5000 && !condition(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  return condition();
}

class ReceiverTest : public testing::Test {
 protected:
  void start() {
    options_.address = "udp://127.0.0.1:" + std::to_string(port_);
    ASSERT_EQ(receiver_.start(options_), Status::ok) << receiver_.problem();
  }
  void send(const wire::EstimateMessage& m) { ASSERT_TRUE(sender_.say(test::packet_of(m), port_)); }
  bool hears(std::uint32_t number) {
    return comes([&] { return receiver_.newest().estimate.number == number; });
  }

  const std::uint16_t port_ = free_port();
  receiver::Options options_;
  Receiver receiver_;
  test::UdpEar sender_;
};

TEST_F(ReceiverTest, HasNothingToFollowBeforeTheFirstPacketAndBeforeTheStart) {
  EXPECT_EQ(receiver_.newest().freshness, Freshness::nothing);
  start();
  EXPECT_EQ(receiver_.newest().freshness, Freshness::nothing);
  EXPECT_FALSE(receiver_.newest().usable());
}

TEST_F(ReceiverTest, PredictsByTheBoardsDelayAndTheTimeSinceTheReceipt) {
  start();
  send(moving(1));
  ASSERT_TRUE(hears(1));
  const Reading reading = receiver_.newest(Receiver::now());
  EXPECT_NEAR(reading.age_s, 0.02 + reading.silence_s, 1e-12);  // a rounding of numbers below 1
  // The same packet, looked at later: nothing is timed here, the time is given.
  const Timestamp t_receipt{Receiver::now().ns - static_cast<std::int64_t>(receiver_.newest().silence_s * 1e9)};
  const Reading later = receiver_.newest({t_receipt.ns + 50'000'000});
  EXPECT_EQ(later.freshness, Freshness::fresh);
  EXPECT_TRUE(later.usable());
  EXPECT_NEAR(later.estimate.joints[0], 0.1 + later.age_s, 1e-12);
}

TEST_F(ReceiverTest, PredictsNoFartherThanTheHorizonAndSaysSo) {
  start();
  send(moving(1));
  ASSERT_TRUE(hears(1));
  for (const std::int64_t wait_ns : {200'000'000LL, 3'600'000'000'000LL}) {
    const Reading reading = receiver_.newest({Receiver::now().ns + wait_ns});
    EXPECT_EQ(reading.freshness, Freshness::stale);
    EXPECT_FALSE(reading.usable());
    EXPECT_NEAR(reading.estimate.joints[0], 0.1 + options_.horizon_s, 1e-12);
    EXPECT_EQ(wire::check(reading.estimate), wire::Fault::none);
  }
}

TEST_F(ReceiverTest, AnEstimateThatWasOldWhenItWasSentIsStaleAtOnce) {
  start();
  wire::EstimateMessage m = moving(1);
  m.t_capture.ns -= 5'000'000'000;
  send(m);
  ASSERT_TRUE(hears(1));
  EXPECT_EQ(receiver_.newest().freshness, Freshness::stale);
}

TEST_F(ReceiverTest, ABoardThatIsLostIsHeardAndNotFollowed) {
  start();
  wire::EstimateMessage m;
  m.session = 1, m.number = 1, m.status = tracker::TrackingStatus::lost;
  send(m);
  ASSERT_TRUE(hears(1));
  EXPECT_EQ(receiver_.newest().estimate.status, tracker::TrackingStatus::lost);
  EXPECT_FALSE(receiver_.newest().usable());
}

TEST_F(ReceiverTest, FollowsTheNewestThroughGarbageLossAndDisorder) {
  start();
  for (const std::uint32_t number : {1u, 2u, 5u, 4u, 4u}) {
    (void)sender_.say(test::Bytes(300, 'g'), port_);
    send(moving(number));
  }
  ASSERT_TRUE(comes([&] { return receiver_.counters().packets == 10; }));
  EXPECT_EQ(receiver_.newest().estimate.number, 5u);
  const receiver::Counters counters = receiver_.counters();
  EXPECT_EQ(counters.estimates, 3u);
  EXPECT_EQ(counters.lost, 1u);
  EXPECT_EQ(counters.reordered, 1u);
  EXPECT_EQ(counters.duplicated, 1u);
  EXPECT_EQ(counters.refused(), 5u);
  EXPECT_EQ(counters.sessions, 1u);
}

TEST_F(ReceiverTest, HasTheNamesOfTheModel) {
  start();
  wire::ModelMessage model;
  EXPECT_FALSE(receiver_.model(model));
  test::Random random{1};
  ASSERT_TRUE(sender_.say(test::packet_of(test::random_model(random, 3)), port_));
  ASSERT_TRUE(comes([&] { return receiver_.model(model); }));
  EXPECT_EQ(wire::view(model.joint_names[2]), "joint_2");
}

TEST_F(ReceiverTest, ReadingDoesNotTouchTheHeap) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  start();
  send(moving(1));
  ASSERT_TRUE(hears(1));
  const test::HeapTrap trap;
  for (int k = 0; k < 1000; ++k) (void)receiver_.newest();
  EXPECT_EQ(trap.calls(), 0);
}

TEST_F(ReceiverTest, WhileOneThreadWritesTheReaderSeesWholeAndRisingEstimates) {
  start();
  std::atomic<bool> done{false};
  std::thread board{[&] {
    for (std::uint32_t k = 1; k <= 3000; ++k) {
      wire::EstimateMessage m = moving(k);
      for (double& x : m.covariance) x = k;
      (void)sender_.say(test::packet_of(m), port_);
    }
    done = true;
  }};
  std::uint32_t before = 0;
  int wrong = 0, looks = 0;
  for (; !done || looks < 100; ++looks) {
    const Reading reading = receiver_.newest();
    const auto& m = reading.estimate;
    if (reading.freshness == Freshness::nothing) continue;
    wrong += std::ranges::count(m.covariance, m.number) == 36 && m.number >= before ? 0 : 1;
    before = m.number;
  }
  board.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(before, 0u);
}

TEST_F(ReceiverTest, HearsAMulticastGroupOnLoopback) {
  options_.address = "udp://239.255.47.48:" + std::to_string(port_) + "?via=127.0.0.1";
  if (receiver_.start(options_) != Status::ok) GTEST_SKIP() << receiver_.problem();
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  const in_addr loopback{htonl(INADDR_LOOPBACK)};
  if (::setsockopt(socket, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback) != 0) {
    ::close(socket);
    GTEST_SKIP() << "this machine, or its emulator, cannot send multicast to loopback";
  }
  sockaddr_in group{};
  group.sin_family = AF_INET, group.sin_port = htons(port_), group.sin_addr.s_addr = ::inet_addr("239.255.47.48");
  const test::Bytes packet = test::packet_of(moving(3));
  EXPECT_GT(::sendto(socket, packet.data(), packet.size(), 0, reinterpret_cast<sockaddr*>(&group), sizeof group), 0);
  EXPECT_TRUE(hears(3));
  ::close(socket);
}

TEST_F(ReceiverTest, SaysWhyItCannotStart) {
  options_.address = "10.0.0.1";
  EXPECT_EQ(receiver_.start(options_), Status::bad_argument);
  EXPECT_NE(receiver_.problem().find("udp://"), std::string::npos) << receiver_.problem();
  options_.address = "udp://192.0.2.1";  // of nobody
  EXPECT_EQ(receiver_.start(options_), Status::io_error);
  options_.address = "serial:///dev/null?baud=12345";
  EXPECT_EQ(receiver_.start(options_), Status::bad_argument);
  EXPECT_NE(receiver_.problem().find("115200"), std::string::npos) << receiver_.problem();
  options_.address = "udp://127.0.0.1", options_.horizon_s = -1;
  EXPECT_EQ(receiver_.start(options_), Status::bad_argument);
  EXPECT_NE(receiver_.problem().find("horizon"), std::string::npos) << receiver_.problem();
}

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

/// The numbers of this program's threads.
std::set<int> threads() {
  std::set<int> all;
  for (const auto& entry : std::filesystem::directory_iterator{"/proc/self/task"}) {
    all.insert(std::stoi(entry.path().filename().string()));
  }
  return all;
}

/// Those that a thread blocks; signal 1 is the lowest bit.
std::uint64_t blocked_signals(int thread) {
  std::ifstream status{"/proc/self/task/" + std::to_string(thread) + "/status"};
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("SigBlk:")) return std::stoull(line.substr(7), nullptr, 16);
  }
  return 0;
}

TEST_F(ReceiverTest, ItsThreadTakesNoSignalAndNoRealTimePriorityFromItsCreator) {
  if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "this system does not tell of its threads";
  const std::set<int> before = threads();
  const std::uint64_t ours = blocked_signals(::getpid());
  const sched_param lowest{.sched_priority = 1}, none{};
  const bool real_time = ::sched_setscheduler(0, SCHED_FIFO, &lowest) == 0;
  start();
  ASSERT_EQ(::sched_setscheduler(0, SCHED_OTHER, &none), 0);
  int receivers = 0;
  for (const int thread : threads()) {
    if (before.contains(thread)) continue;
    ++receivers;
    EXPECT_TRUE(comes([&] { return ::sched_getscheduler(thread) == SCHED_OTHER; }));
    for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGUSR1, SIGALRM, SIGCHLD}) {
      EXPECT_EQ(blocked_signals(thread) >> (signal - 1) & 1, 1u) << "signal " << signal;
    }
  }
  EXPECT_EQ(receivers, 1);
  EXPECT_EQ(blocked_signals(::getpid()), ours) << "the creator has its own back";
  RecordProperty("creator_was_real_time", real_time ? 1 : 0);
}

TEST_F(ReceiverTest, CanBeStoppedAndStartedAgain) {
  start();
  send(moving(1));
  ASSERT_TRUE(hears(1));
  receiver_.stop();
  EXPECT_EQ(receiver_.newest().freshness, Freshness::nothing);
  start();
  send(moving(2));
  EXPECT_TRUE(hears(2));
}

}  // namespace
}  // namespace articam
