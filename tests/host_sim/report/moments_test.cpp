#include "host_sim/report/moments.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

TEST(Moments, ShowWhatWasNotTracked) {
  const Moments chosen = moments(test::late_run());
  EXPECT_EQ(chosen.event, 100u);  // the one lost frame
  EXPECT_LT(chosen.film.front(), 100u);
  EXPECT_GT(chosen.film.back(), 100u);
  EXPECT_EQ(chosen.film.size(), 30u);
}

TEST(Moments, ShowTheFastestMotionWhereAllWasTracked) {
  RunRecord run = test::late_run();
  run.frames[100].status = tracker::TrackingStatus::tracking;
  // The slide moves as cos(t): after the first second fastest at pi and 2 pi.
  const double t_s = run.frames[moments(run).event].t_s;
  EXPECT_NEAR(std::abs(std::cos(t_s)), 1, 0.01);
}

TEST(Moments, OfAShortRunAreInsideIt) {
  RunRecord run = test::late_run();
  run.frames.resize(3);
  const Moments chosen = moments(run);
  EXPECT_LT(chosen.start, 3u);
  EXPECT_LT(chosen.event, 3u);
  for (const std::size_t frame : chosen.film) EXPECT_LT(frame, 3u);
}

}  // namespace
}  // namespace articam::sim
