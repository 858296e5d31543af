#include "tools/identify/recording.hpp"

#include <gtest/gtest.h>

namespace articam::identify {
namespace {

/// One mark at that column, one joint at that value.
Moment moment(double u_px, double joint = 0, double deviation = 1e-5) {
  return {{}, {joint}, {deviation}, {{0, {u_px, 100}, 1e-4, 1e-6}}};
}

TEST(SpreadOut, TakesAllOfAFew) { EXPECT_EQ(spread_out({moment(0), moment(1)}, 5).size(), 2u); }

TEST(SpreadOut, PrefersTheMomentsInWhichSomethingMoves) {
  Recording recording;
  for (int i = 0; i < 900; ++i) recording.push_back(moment(0));
  for (int i = 0; i < 100; ++i) recording.push_back(moment(i));
  const Recording chosen = spread_out(recording, 100);
  EXPECT_NEAR(static_cast<double>(chosen.size()), 100, 1);
  const auto moving =
      std::count_if(chosen.begin(), chosen.end(), [](const Moment& m) { return m.sightings[0].pixel.x() > 0; });
  EXPECT_GT(moving, 50);  // a tenth of the time, and all of the way
  EXPECT_LT(moving, 60);
}

TEST(MindRepetition, KeepsTheBiasOfWhatIsSeenInOnePlaceAgainAndAgain) {
  Recording recording;
  for (int i = 0; i < 100; ++i) recording.push_back(moment(5.1));
  recording.push_back(moment(8.1));
  mind_repetition(recording);
  EXPECT_DOUBLE_EQ(recording.front().sightings[0].variance_px2, 1e-4 + 100 * 1e-6);
  EXPECT_DOUBLE_EQ(recording.back().sightings[0].variance_px2, 1e-4 + 1e-6);
}

TEST(FindStill, TellsAJointThatRestsFromOneThatMoves) {
  Recording rests, moves;
  for (int i = 0; i < 100; ++i) {
    rests.push_back(moment(0, 0.1 + 1e-5 * (i % 3), 1e-5));
    moves.push_back(moment(0, 1e-4 * i, 1e-5));
  }
  EXPECT_EQ(find_still(rests, {true}), std::vector{0});
  EXPECT_TRUE(find_still(moves, {true}).empty());
  EXPECT_EQ(find_still(moves, {false}), std::vector<int>{});  // 0.01 rad are more than half a degree
  EXPECT_TRUE(find_still({}, {true}).empty());
}

}  // namespace
}  // namespace articam::identify
