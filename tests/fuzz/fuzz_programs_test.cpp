/// @file  The programs of this folder from outside, and a receiver in the middle of a flood.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "hal/receiver/take_packets.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/udp_ear.hpp"

namespace articam {
namespace {

const std::string kFlood = ARTICAM_BIN "/articam-flood ";
const std::string kFuzz = ARTICAM_BIN "/articam-fuzz-link ";

TEST(FuzzLinkProgram, ReachesEveryFaultThatNeedsNoKeyAndRepeatsItself) {
  const test::Ended first = test::run(kFuzz + "--inputs 4000 --seed 3");
  EXPECT_EQ(first.exit_code, 0) << first.text;
  for (const char* const word : {"messages taken", "foreign", "wrong_length", "wrong_checksum", "unknown_format",
                                 "malformed", "unknown_schema", "inconsistent"}) {
    EXPECT_NE(first.text.find(word), std::string::npos) << word << " was never reached:\n" << first.text;
  }
  EXPECT_EQ(test::run(kFuzz + "--inputs 4000 --seed 3").text, first.text);
  EXPECT_EQ(test::run(kFuzz + "--inputs none").exit_code, 2);
}

TEST(FloodProgram, FloodsThisMachineOnly) {
  for (const char* const to : {"10.0.0.1:47047", "239.1.1.1:47047", "localhost:1", "127.0.0.1:0"}) {
    const test::Ended ended = test::run(kFlood + "--seconds 0.01 --to " + to);
    EXPECT_EQ(ended.exit_code, 2) << to;
    EXPECT_NE(ended.text.find(to), std::string::npos) << ended.text;
  }
  EXPECT_EQ(test::run(kFlood).exit_code, 2);
}

TEST(FloodProgram, AReceiverInTheFloodReadsInBoundedPiecesAndTakesNothing) {
  wire::Address address;
  address.host = {127, 0, 0, 1};
  address.port = test::UdpEar{}.port();
  hal::PacketInlet inlet;
  ASSERT_EQ(inlet.open(address), "");
  std::atomic<bool> done{false};
  test::Ended ended;
  std::thread flood{[&] {
    ended = test::run(kFlood + "--seconds 1 --rate 100000 --to 127.0.0.1:" + std::to_string(address.port));
    done = true;
  }};
  receiver::Intake intake;
  std::uint64_t most = 0;
  int taken = 0;
  while (!done) {
    const std::uint64_t before = intake.counters().packets;
    if (inlet.wait(10) != Status::ok) continue;
    EXPECT_NE(receiver::take_packets(inlet, intake, [&](auto...) { ++taken; }), Status::io_error);
    most = std::max(most, intake.counters().packets - before);
  }
  flood.join();
  EXPECT_EQ(ended.exit_code, 0) << ended.text;
  EXPECT_GT(intake.counters().packets, 0u);
  EXPECT_EQ(intake.counters().refused(), intake.counters().packets);
  EXPECT_LE(most, static_cast<std::uint64_t>(receiver::kMostAtOnce));
  EXPECT_EQ(taken, 0);
}

}  // namespace
}  // namespace articam
