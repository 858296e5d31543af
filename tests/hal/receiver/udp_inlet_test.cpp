#include "hal/receiver/udp_inlet.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/udp_ear.hpp"
#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using receiver::Intake;
using receiver::UdpInlet;

/// An inlet on a port that was free a moment ago.
class UdpInletTest : public testing::Test {
 protected:
  void SetUp() override {
    {
      const test::UdpEar free;
      address_.port = free.port();
    }
    address_.host = {127, 0, 0, 1};
    ASSERT_EQ(inlet_.open(address_, problem_), Status::ok) << problem_;
  }
  int read() {
    return inlet_.read(intake_, [this](Intake::Taken, Timestamp) { ++taken_; });
  }

  wire::Address address_{};
  UdpInlet inlet_;
  Intake intake_;
  test::UdpEar sender_;
  std::string problem_;
  int taken_{};
};

TEST_F(UdpInletTest, ReadsNothingWhereNothingIsAndDoesNotWait) {
  EXPECT_EQ(inlet_.wait(0), Status::timeout);
  EXPECT_EQ(read(), 0);
}

TEST_F(UdpInletTest, AFloodIsReadInBoundedPieces) {
  for (int k = 0; k < 10 * UdpInlet::kMostAtOnce; ++k) (void)sender_.say(test::Bytes(40, 'x'), address_.port);
  ASSERT_EQ(inlet_.wait(1000), Status::ok);
  EXPECT_EQ(read(), UdpInlet::kMostAtOnce);
  int most = 0;
  while (const int count = read()) most = std::max(most, count);
  EXPECT_LE(most, UdpInlet::kMostAtOnce);
  EXPECT_EQ(intake_.counters().refused(), intake_.counters().packets);
  EXPECT_EQ(taken_, 0);
}

TEST_F(UdpInletTest, TakesItsPacketsFromAmongGarbageOfEverySize) {
  test::Random random{1};
  for (std::uint32_t k = 0; k < 20; ++k) {
    (void)sender_.say(test::Bytes(static_cast<std::size_t>(random.uniform(0, 9000)), 'A'), address_.port);
    wire::EstimateMessage m = test::random_estimate(random);
    m.number = k, m.session = 1;
    (void)sender_.say(test::packet_of(m), address_.port);
    while (read() > 0) continue;
  }
  EXPECT_EQ(taken_, 20);
  EXPECT_EQ(intake_.counters().lost, 0u);
  EXPECT_EQ(intake_.counters().refused(), 20u);
}

TEST_F(UdpInletTest, SaysWhyAnAddressCannotBeListenedTo) {
  UdpInlet second;
  EXPECT_EQ(second.open(address_, problem_), Status::io_error);
  EXPECT_NE(problem_.find("udp://127.0.0.1:" + std::to_string(address_.port)), std::string::npos) << problem_;
  EXPECT_NE(problem_.find("in use"), std::string::npos) << problem_;
  wire::Address serial;
  EXPECT_EQ(wire::parse_address("serial:///dev/ttyS0", serial), "");
  EXPECT_EQ(second.open(serial, problem_), Status::bad_argument);
}

}  // namespace
}  // namespace articam
