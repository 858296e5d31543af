#include "hal/receiver/take_packets.hpp"

#include <gtest/gtest.h>

#include "tests/support/udp_ear.hpp"
#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using receiver::Intake;
using receiver::kMostAtOnce;

/// An inlet on a port that was free a moment ago.
class TakePackets : public testing::Test {
 protected:
  void SetUp() override {
    address_.port = test::UdpEar{}.port();
    address_.host = {127, 0, 0, 1};
    ASSERT_EQ(inlet_.open(address_), "");
  }
  Status take() {
    return receiver::take_packets(inlet_, intake_, [this](Intake::Taken, Timestamp) { ++taken_; });
  }

  wire::Address address_{};
  hal::PacketInlet inlet_;
  Intake intake_;
  test::UdpEar sender_;
  int taken_{};
};

TEST_F(TakePackets, AFloodIsReadInBoundedPieces) {
  for (int k = 0; k < 3 * kMostAtOnce; ++k) (void)sender_.say(test::Bytes(40, 'x'), address_.port);
  ASSERT_EQ(inlet_.wait(1000), Status::ok);
  std::uint64_t before = 0;
  while (take() == Status::ok) {
    EXPECT_EQ(intake_.counters().packets - before, static_cast<std::uint64_t>(kMostAtOnce));
    before = intake_.counters().packets;
  }
  EXPECT_GT(before, 0u);
  EXPECT_EQ(intake_.counters().refused(), intake_.counters().packets);
  EXPECT_EQ(taken_, 0);
}

TEST_F(TakePackets, FindsOursAmongGarbageOfEverySize) {
  test::Random random{1};
  for (std::uint32_t k = 0; k < 20; ++k) {
    (void)sender_.say(test::Bytes(static_cast<std::size_t>(random.uniform(0, 9000)), 'A'), address_.port);
    wire::EstimateMessage m = test::random_estimate(random);
    m.number = k, m.session = 1;
    (void)sender_.say(test::packet_of(m), address_.port);
    EXPECT_EQ(take(), Status::timeout) << "all has been read";
  }
  EXPECT_EQ(taken_, 20);
  EXPECT_EQ(intake_.counters().lost, 0u);
  EXPECT_EQ(intake_.counters().refused(), 20u);
}

}  // namespace
}  // namespace articam
