#include "hal/app/board/statistics.hpp"

#include <gtest/gtest.h>

#include "tests/support/heap_trap.hpp"

namespace articam {
namespace {

app::Statistics::Turn turn(double t_s, double age_s, hal::Tick tick = hal::Tick::estimated) {
  return {from_seconds(t_s), tick, from_seconds(t_s - age_s), tracker::TrackingStatus::tracking, tracker::Reason::none};
}

TEST(Statistics, MeasurePeriodAndAgeOfWhatTheLoopTells) {
  app::Statistics statistics{false};
  statistics.add(turn(10.0, 0.01), {});
  statistics.add(turn(10.1, 0.02), {});
  statistics.add(turn(10.4, 0.03), {.dropped = 2});
  statistics.add(turn(10.5, 9.0, hal::Tick::coasted), {.dropped = 2});  // no frame: its age is not a frame's
  const app::LoopWindow& total = statistics.total();
  constexpr double kRounding = 1e-12;
  EXPECT_EQ(total.ticks, 3u);
  EXPECT_NEAR(total.span_s, 0.5, kRounding);
  EXPECT_NEAR(total.period_min_s, 0.1, kRounding);
  EXPECT_NEAR(total.period_max_s, 0.3, kRounding);
  EXPECT_EQ(total.estimates, 3u);
  EXPECT_NEAR(total.age_sum_s, 0.06, kRounding);
  EXPECT_NEAR(total.age_max_s, 0.03, kRounding);
  EXPECT_EQ(total.counters.dropped, 2u);
}

TEST(Statistics, SayItInOneLine) {
  app::LoopWindow window;
  window.ticks = 30, window.span_s = 1;
  window.period_sum_s = 1, window.period_square_sum_s2 = 30 * (1.0 / 900 + 1e-8);  // a deviation of 0.1 ms
  window.period_min_s = 0.033, window.period_max_s = 0.034;
  window.estimates = 30, window.age_sum_s = 0.12, window.age_max_s = 0.005;
  window.counters = {.dropped = 1, .refused = 2, .timeouts = 3, .late = 4, .camera_errors = 5, .link_errors = 6};
  window.status = tracker::TrackingStatus::degraded;
  window.reason = tracker::Reason::weak_joint;
  EXPECT_EQ(app::WindowText{window}.text(),
            "30.0 Hz  period 33.33 ms (jitter 0.100, 33.00 to 34.00)  age 4.00 ms (max 5.00)  dropped 1  refused 2  "
            "silent 3  late 4  camera errors 5  unsent 6  degraded (weak_joint)");
}

TEST(Statistics, NeitherAllocateNorWaitInTheLoop) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  testing::internal::CaptureStderr();
  {
    app::Statistics statistics{true};
    const test::HeapTrap trap;
    for (int k = 0; k < 300; ++k) statistics.add(turn(k / 30.0, 0.004), {});  // ten seconds: ten lines, or fewer
    EXPECT_EQ(trap.calls(), 0);
    EXPECT_EQ(statistics.total().ticks, 299u);
  }
  (void)testing::internal::GetCapturedStderr();
}

}  // namespace
}  // namespace articam
