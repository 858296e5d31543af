#include "tools/listen/listener.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/wire_messages.hpp"

namespace articam::listen {
namespace {

class ListenerTest : public testing::Test {
 protected:
  void hear(const test::Bytes& packet) { listener_.take({packet, {1}, 2, true}); }
  void hear_model(std::uint64_t session) {
    auto model = test::random_model(random_);
    model.session = session;
    hear(test::packet_of(model));
  }
  void hear_estimate(std::uint64_t session, std::uint32_t number) {
    auto estimate = test::random_estimate(random_);
    estimate.session = session, estimate.number = number, estimate.model_hash = 7;
    hear(test::packet_of(estimate));
  }
  std::uint64_t count(wire::Fault fault) { return listener_.statistics().faults[static_cast<std::size_t>(fault)]; }

  test::Random random_{24};
  int delivered_{};
  Listener listener_{[this](const Heard&) { ++delivered_; }};
};

TEST_F(ListenerTest, KeepsBoardsOfOneGroupApart) {
  for (const std::uint64_t session : {1u, 2u}) hear_model(session);
  for (std::uint32_t number = 0; number < 10; ++number) {
    hear_estimate(1, number);
    hear_estimate(2, 2 * number);
  }
  const Statistics& statistics = listener_.statistics();
  EXPECT_EQ(delivered_, 20);
  EXPECT_EQ(statistics.sessions, 2u);
  EXPECT_EQ(statistics.estimates.received, 20u);
  EXPECT_EQ(statistics.estimates.lost, 9u) << "every second one of the second board, before its last";
}

TEST_F(ListenerTest, CountsBadPacketsByTheirReasonAndGoesOn) {
  hear_model(1);
  hear({});
  hear({'A', 'T', 'C', 'M', 1});
  auto flipped = test::packet_of(test::random_estimate(random_));
  flipped[30] ^= 4;
  hear(flipped);
  hear_estimate(1, 0);
  EXPECT_EQ(count(wire::Fault::foreign), 1u);
  EXPECT_EQ(count(wire::Fault::wrong_length), 1u);
  EXPECT_EQ(count(wire::Fault::wrong_checksum), 1u);
  EXPECT_EQ(listener_.statistics().bad(), 3u);
  EXPECT_EQ(delivered_, 1);
  const std::string text = table(listener_.statistics());
  EXPECT_NE(text.find("foreign 1, wrong_length 1, wrong_checksum 1"), std::string::npos) << text;
}

TEST_F(ListenerTest, KeepsTheCountsOfSessionsThatItForgets) {
  constexpr std::uint64_t kSessions = 5 * Listener::kMaxSessions;
  for (std::uint64_t session = 0; session < kSessions; ++session) {
    hear_estimate(session, 0);
    hear_estimate(session, 2);
  }
  const Statistics& statistics = listener_.statistics();
  EXPECT_EQ(statistics.sessions, kSessions);
  EXPECT_EQ(statistics.estimates.received, 2 * kSessions);
  EXPECT_EQ(statistics.estimates.lost, kSessions);
  EXPECT_EQ(statistics.unnamed, 2 * kSessions);
  EXPECT_EQ(delivered_, 0);
}

TEST_F(ListenerTest, SurvivesEveryChangedByte) {
  hear_model(1);
  const auto good = test::packet_of(test::random_estimate(random_));
  std::uint64_t sent = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    auto bad = good;
    bad[i] = static_cast<std::uint8_t>(bad[i] + 1 + i % 255);
    hear(bad);
    hear({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(i)});
    sent += 2;
  }
  EXPECT_EQ(listener_.statistics().bad(), sent);
  EXPECT_EQ(delivered_, 0);
}

}  // namespace
}  // namespace articam::listen
