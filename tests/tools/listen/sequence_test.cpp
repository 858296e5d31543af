#include "tools/listen/sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/support/random_state.hpp"

namespace articam::listen {
namespace {

Counts hear(const std::vector<std::uint32_t>& numbers) {
  Sequence sequence;
  for (const std::uint32_t number : numbers) sequence.take(number);
  return sequence.counts();
}

TEST(Sequence, CountsGapsDuplicatesAndLateOnes) {
  EXPECT_EQ(hear({}).lost, 0u);
  EXPECT_EQ(hear({7, 8, 10}).lost, 1u);
  EXPECT_EQ(hear({7, 8, 10, 9}).lost, 0u);
  EXPECT_EQ(hear({7, 8, 10, 9}).reordered, 1u);
  EXPECT_EQ(hear({7, 7, 7}).duplicates, 2u);
  EXPECT_EQ(hear({8, 7}).received, 2u) << "overtaken before anything was heard";
}

TEST(Sequence, GoesOnWhereTheNumbersWrapRound) {
  constexpr std::uint32_t kMax = 0xffff'ffff;
  const Counts counts = hear({kMax - 1, kMax, 0, 3, 1, kMax});
  EXPECT_EQ(counts.received, 5u);
  EXPECT_EQ(counts.lost, 1u) << "2";
  EXPECT_EQ(counts.reordered, 1u);
  EXPECT_EQ(counts.duplicates, 1u);
}

TEST(Sequence, IsNotLedAstrayByTheLargestNumber) {
  Sequence sequence;
  sequence.take(5000);
  EXPECT_FALSE(sequence.take(0xffff'ffff));
  EXPECT_TRUE(sequence.take(5001));
  EXPECT_EQ(sequence.counts().lost, 0u);
}

TEST(Sequence, HoldsReceivedAndLostTogetherToWhatWasSent) {
  test::Random random{5};
  std::set<std::uint32_t> heard;
  Sequence sequence;
  std::uint32_t newest = 100;
  std::uint64_t duplicates = 0;
  sequence.take(newest);
  heard.insert(newest);
  for (int i = 0; i < 20000; ++i) {
    const auto number = static_cast<std::uint32_t>(
        std::max(100.0, static_cast<double>(newest) + random.uniform(1.0 - Sequence::kMemory, 30)));
    if (number <= newest && newest - number >= Sequence::kMemory) continue;  // that is the next test
    const bool is_new = heard.insert(number).second;
    ASSERT_EQ(sequence.take(number), is_new) << "seed 5, packet " << i;
    duplicates += is_new ? 0 : 1;
    newest = std::max(newest, number);
  }
  const Counts counts = sequence.counts();
  EXPECT_EQ(counts.received, heard.size());
  EXPECT_EQ(counts.duplicates, duplicates);
  EXPECT_EQ(counts.received + counts.lost, newest - 100 + 1);
}

TEST(Sequence, RefusesWhatIsTooOldToTell) {
  Sequence sequence;
  sequence.take(0);
  sequence.take(4 * Sequence::kMemory);
  EXPECT_FALSE(sequence.take(1));
  EXPECT_TRUE(sequence.take(3 * Sequence::kMemory + 1)) << "its place held nothing of this round";
  EXPECT_EQ(sequence.counts().received + sequence.counts().lost, 4 * Sequence::kMemory + 1);
}

}  // namespace
}  // namespace articam::listen
