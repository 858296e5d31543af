#include "hal/receiver/intake.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using receiver::Counters;
using receiver::Intake;
using Taken = Intake::Taken;
using wire::Fault;

test::Bytes packet(std::uint32_t number, std::uint64_t session = 1, std::uint64_t model_hash = 9) {
  test::Random random{number};
  wire::EstimateMessage m = test::random_estimate(random);
  m.number = number, m.session = session, m.model_hash = model_hash;
  return test::packet_of(m);
}

class IntakeTest : public testing::Test {
 protected:
  /// Whether each of these numbers counts, one every 10 ms.
  std::string take(std::initializer_list<std::uint32_t> numbers, std::uint64_t session = 1) {
    std::string taken;
    for (const std::uint32_t n : numbers) {
      now_.ns += 10'000'000;
      taken += intake_.take(packet(n, session), now_) == Taken::estimate ? '+' : '-';
    }
    return taken;
  }
  const Counters& counters() const { return intake_.counters(); }

  Intake intake_;
  Timestamp now_{};
};

TEST_F(IntakeTest, TakesWhatIsNewerAndCountsWhatIsMissing) {
  EXPECT_EQ(take({5, 6, 9, 10}), "++++");
  EXPECT_EQ(counters().estimates, 4u);
  EXPECT_EQ(counters().lost, 2u) << "7 and 8; what was before the first is not missed";
  EXPECT_EQ(intake_.message().estimate.number, 10u);
}

TEST_F(IntakeTest, DropsWhatIsLateAndNoLongerCountsItAsLost) {
  EXPECT_EQ(take({1, 3, 2, 4}), "++-+");
  EXPECT_EQ(counters().reordered, 1u);
  EXPECT_EQ(counters().lost, 0u);
}

TEST_F(IntakeTest, DropsDuplicatesOfTheNewestAndOfOlderOnes) {
  EXPECT_EQ(take({1, 1, 2, 3, 1, 5, 4, 4}), "+-++-+--");
  EXPECT_EQ(counters().duplicated, 3u);
  EXPECT_EQ(counters().reordered, 1u);
  EXPECT_EQ(counters().lost, 0u);
}

TEST_F(IntakeTest, CountsAPacketThatIsVeryLateAsLostAndReordered) {
  EXPECT_EQ(take({1, 103, 2}), "++-");
  EXPECT_EQ(counters().lost, 101u);
  EXPECT_EQ(counters().reordered, 1u);
}

TEST_F(IntakeTest, NumbersMayWrapRound) {
  constexpr auto kMax = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(take({kMax - 1, kMax, 0, 2, 1}), "++++-");
  EXPECT_EQ(counters().lost, 0u);
}

TEST_F(IntakeTest, ANewSessionBeginsAnewAndLatePacketsOfTheOldOneAreDropped) {
  EXPECT_EQ(take({1000, 1001}), "++");
  EXPECT_EQ(take({0, 1}, 2), "++");
  EXPECT_EQ(take({1002}, 1), "-");
  EXPECT_EQ(take({2}, 2), "+");
  EXPECT_EQ(counters().sessions, 2u);
  EXPECT_EQ(counters().lost, 0u);
  now_.ns += 2'000'000'000;
  EXPECT_EQ(take({1003}, 1), "+") << "the other board is silent: this one is alive";
}

TEST_F(IntakeTest, EveryPacketWithOneFlippedBitIsDroppedAndCountedAndChangesNothingElse) {
  ASSERT_EQ(take({7}), "+");
  test::Bytes next = packet(8);
  for (std::size_t bit = 0; bit < 8 * next.size(); ++bit) {
    next[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    ASSERT_EQ(intake_.take(next, now_), Taken::nothing) << "bit " << bit;
    next[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
  }
  EXPECT_EQ(counters().refused(), 8 * next.size());
  EXPECT_EQ(counters().faults[static_cast<std::size_t>(Fault::foreign)], 32u);
  EXPECT_EQ(intake_.message().estimate.number, 7u);
  EXPECT_EQ(take({8}), "+");
  EXPECT_EQ(counters().lost, 0u);
}

TEST_F(IntakeTest, EveryTruncatedPacketIsDroppedAndCounted) {
  const test::Bytes whole = packet(1);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ASSERT_EQ(intake_.take(std::span{whole}.first(size), now_), Taken::nothing);
  }
  EXPECT_EQ(counters().refused(), whole.size());
  EXPECT_EQ(counters().sessions, 0u);
}

TEST_F(IntakeTest, AnotherModelIsRefusedWhereOneIsAskedFor) {
  Intake strict{9};
  EXPECT_EQ(strict.take(packet(1, 1, 8), now_), Taken::nothing);
  EXPECT_EQ(strict.counters().faults[static_cast<std::size_t>(Fault::wrong_model)], 1u);
  EXPECT_EQ(strict.counters().sessions, 0u);
  EXPECT_EQ(strict.take(packet(1, 1, 9), now_), Taken::estimate);
}

TEST_F(IntakeTest, ASoundPacketWithNumbersThatAreNotFiniteIsRefused) {
  test::Random random{1};
  wire::EstimateMessage m = test::random_estimate(random);
  m.joints[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(intake_.take(test::packet_of(m), now_), Taken::nothing);
  EXPECT_EQ(counters().faults[static_cast<std::size_t>(Fault::inconsistent)], 1u);
}

TEST_F(IntakeTest, OnceAnEstimateHasComeOnlyTheModelOfItsSessionIsTaken) {
  test::Random random{1};
  wire::ModelMessage model = test::random_model(random);
  ASSERT_EQ(take({1}, 5), "+");
  for (const std::uint64_t session : {4u, 5u, 6u}) {
    model.session = session;
    EXPECT_EQ(intake_.take(test::packet_of(model), now_), session == 5 ? Taken::model : Taken::nothing);
  }
}

TEST_F(IntakeTest, NamesOfTheModelAreTakenBesideTheEstimates) {
  test::Random random{1};
  EXPECT_EQ(intake_.take(test::packet_of(test::random_model(random)), now_), Taken::model);
  EXPECT_EQ(counters().models, 1u);
  EXPECT_EQ(counters().estimates, 0u);
}

}  // namespace
}  // namespace articam
