#include "hal/posix/packet_inlet.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

#include "hal/link/udp_transport.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "tests/support/pseudo_terminal.hpp"
#include "tests/support/udp_ear.hpp"

namespace articam {
namespace {

using Bytes = std::vector<std::uint8_t>;
using hal::Inbound;
using hal::PacketInlet;

Timestamp now() { return hal::MonotonicClock{}.now(); }

std::int64_t wall_ns() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970).count();
}

class UdpInlet : public testing::Test {
 protected:
  void SetUp() override {
    address_.host = {127, 0, 0, 1};
    address_.port = test::UdpEar{}.port();  // was free a moment ago
    ASSERT_EQ(inlet_.open(address_), "");
  }
  /// Sends one packet, and reads it so much later.
  Inbound pass(const Bytes& packet, std::chrono::milliseconds later = {}) {
    Inbound in;
    EXPECT_TRUE(sender_.say(packet, address_.port));
    sent_ = now();
    std::this_thread::sleep_for(later);
    EXPECT_EQ(inlet_.wait(1000), Status::ok);
    EXPECT_EQ(inlet_.next(in), Status::ok);
    return in;
  }

  wire::Address address_{};
  PacketInlet inlet_;
  test::UdpEar sender_;
  Timestamp sent_{};
};

TEST_F(UdpInlet, HasNothingWhereNothingIsAndDoesNotWait) {
  Inbound in;
  EXPECT_EQ(inlet_.wait(0), Status::timeout);
  EXPECT_EQ(inlet_.next(in), Status::timeout);
}

TEST_F(UdpInlet, HearsDatagramsOfEverySizeAndWhoHasSentThem) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, wire::kMaxPacketSize, std::size_t{20000}}) {
    const Inbound in = pass(Bytes(size, 7));
    EXPECT_EQ(in.bytes.size(), std::min(size, wire::kMaxPacketSize + 1)) << "too long is told from just fitting";
    EXPECT_EQ(in.from, address_.host);
  }
}

TEST_F(UdpInlet, APacketIsAsOldAsItIsHoweverLateItIsReadOnBothClocks) {
  constexpr int kOn = 1;
  const int probe = ::socket(AF_INET, SOCK_DGRAM, 0);
  const bool stamps = ::setsockopt(probe, SOL_SOCKET, SO_TIMESTAMPNS, &kOn, sizeof kOn) == 0;
  ::close(probe);
  if (!stamps) GTEST_SKIP() << "this system, or its emulator, does not stamp packets";
  // The kernel begins to stamp some time after it was first asked; what it has not stamped counts from the reading.
  bool is_stamped = false;
  for (int attempt = 0; attempt < 100 && !is_stamped; ++attempt) {
    const Inbound in = pass({1}, std::chrono::milliseconds{20});
    EXPECT_LE(in.t_receipt, now());
    const auto apart_ns = in.t_receipt_wall_ns - in.t_receipt.ns - (wall_ns() - now().ns);
    // On loopback a packet has come when it is sent. Half of the wait is far more than two readings are apart.
    is_stamped = in.t_receipt <= sent_ && std::abs(apart_ns) < 10'000'000;
  }
  EXPECT_TRUE(is_stamped);
}

TEST_F(UdpInlet, SaysWhyAnAddressCannotBeListenedTo) {
  PacketInlet second;
  EXPECT_EQ(second.open(address_), "cannot be listened to");
  EXPECT_EQ(errno, EADDRINUSE);
  EXPECT_EQ(hal::place_of(address_), "udp://127.0.0.1:" + std::to_string(address_.port));
  inlet_.close();
  EXPECT_EQ(second.open(address_), "");
}

TEST(GroupInlet, SharesAGroupWithOthers) {
  wire::Address group;
  const std::string text = "udp://239.255.47.48:" + std::to_string(test::UdpEar{}.port()) + "?via=127.0.0.1";
  ASSERT_EQ(wire::parse_address(text, group), "");
  PacketInlet first, second;
  if (!first.open(group).empty()) GTEST_SKIP() << "no multicast here";
  EXPECT_EQ(second.open(group), "");
}

/// Such as a USB adapter. False where this system lets nobody do that.
bool plug_in_interface() {
  return std::system(
             "(ip link add board0 type veth peer name board1 && ip address add 10.9.9.1/24 dev board0 &&"
             " ip link set board0 up && ip link set board1 up) 2>/dev/null") == 0;
}

TEST(GroupInlet, IsHeardAgainOnceItsInterfaceHasGoneAndComeBack) {
  bool possible = false, heard_before = false, heard_after = false;
  std::thread network_of_its_own{[&] {
    wire::Address group;
    EXPECT_EQ(wire::parse_address("udp://239.1.1.1?via=10.9.9.1", group), "");
    if (::unshare(CLONE_NEWNET) != 0 || !plug_in_interface()) return;
    possible = hal::UdpTransport{}.open(group) == Status::ok;
    if (!possible) return;
    PacketInlet inlet;
    EXPECT_EQ(inlet.open(group), "");
    const auto hears = [&] {
      hal::UdpTransport board;
      EXPECT_EQ(board.open(group), Status::ok);
      for (int turn = 0; turn < 50; ++turn) {
        (void)board.send(Bytes{1});
        if (inlet.wait(20) == Status::ok) return true;
      }
      return false;
    };
    heard_before = hears();
    Inbound in;
    while (inlet.next(in) == Status::ok) continue;
    EXPECT_EQ(std::system("ip link delete board0"), 0);
    EXPECT_TRUE(plug_in_interface());
    heard_after = hears();
  }};
  network_of_its_own.join();
  if (!possible) GTEST_SKIP() << "it takes root, iproute2 and no emulator to make a network of our own";
  EXPECT_TRUE(heard_before);
  EXPECT_TRUE(heard_after);
}

class SerialInlet : public testing::Test {
 protected:
  void SetUp() override {
    if (!board_.works()) GTEST_SKIP() << "no pseudo terminal here";
    ASSERT_EQ(wire::parse_address("serial://" + board_.path(), address_), "");
    ASSERT_EQ(inlet_.open(address_), "");
  }
  /// The next whole packet; empty when there is none for now.
  Bytes hear() {
    Inbound in;
    while (inlet_.wait(50) == Status::ok) {
      if (inlet_.next(in) == Status::ok) return {in.bytes.begin(), in.bytes.end()};
    }
    return {};
  }

  test::PseudoTerminal board_;
  wire::Address address_{};
  PacketInlet inlet_;
};

TEST_F(SerialInlet, TakesFramesApartThatCameInOnePieceOrInSeveral) {
  const Bytes first{1, 0, 2}, second{3, 3, 0, 0};
  Bytes stream{0};
  for (const auto& packet : {first, second, first}) {
    const Bytes frame = test::framed(packet);
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  const std::span all{stream};
  ASSERT_TRUE(board_.say(all.first(all.size() - 2)));
  EXPECT_EQ(hear(), first);
  EXPECT_EQ(hear(), second);
  EXPECT_EQ(hear(), Bytes{});
  ASSERT_TRUE(board_.say(all.last(2)));
  EXPECT_EQ(hear(), first);
  EXPECT_EQ(inlet_.broken_frames(), 0u);
}

TEST_F(SerialInlet, CountsBrokenFramesAndIsInStepAgainAfterThem) {
  ASSERT_TRUE(board_.say(Bytes{9, 1, 0, 3, 1, 2, 0}));
  EXPECT_EQ(hear(), (Bytes{1, 2}));
  EXPECT_EQ(inlet_.broken_frames(), 1u);
}

TEST_F(SerialInlet, ALineThatIsGoneIsAnErrorWithAReason) {
  board_.hang_up();
  Inbound in;
  ASSERT_EQ(inlet_.wait(1000), Status::ok);
  EXPECT_EQ(inlet_.next(in), Status::io_error);
  EXPECT_EQ(errno, EIO);
  EXPECT_NE(inlet_.open(address_), "");
}

TEST_F(SerialInlet, ForgetsTheHalfOfAFrameWhenItIsOpenedAnew) {
  ASSERT_TRUE(board_.say(Bytes{3, 7}));
  EXPECT_EQ(hear(), Bytes{});
  ASSERT_EQ(inlet_.open(address_), "");
  ASSERT_TRUE(board_.say(test::framed(Bytes{4, 5})));
  EXPECT_EQ(hear(), (Bytes{4, 5}));
}

}  // namespace
}  // namespace articam
