#include "hal/receiver/receiver.hpp"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>

#include "hal/wire/message_reader.hpp"
#include "tests/hal/receiver/receiver_fixture.hpp"
#include "tests/support/heap_trap.hpp"

namespace articam {
namespace {

using receiver::Freshness;
using receiver::Reading;
using receiver::Receiver;
using test::comes;
using test::moving;
using test::ReceiverTest;

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
