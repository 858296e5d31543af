#include "hal/run_loop.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hal/memory/latest_link.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/memory/memory_camera.hpp"
#include "tests/support/fake_tracker.hpp"

namespace articam {
namespace {

using hal::Tick;

using test::FakeEstimate;
using test::FakeTracker;
using tracker::Reason;
using tracker::TrackingStatus;

struct UnpluggedCamera {
  Status start() noexcept { return Status::no_device; }
  void stop() noexcept {}
  Status acquire(hal::Frame&, std::chrono::milliseconds) noexcept { return Status::no_device; }
  void release(hal::Frame&) noexcept {}
};

struct BrokenLink {
  Status publish(const FakeEstimate&) noexcept { return Status::io_error; }
};

constexpr hal::LoopTimes kTimes{.period = std::chrono::milliseconds{100}, .max_age_s = 0.15};

class RunLoop : public testing::Test {
 protected:
  Tick show(std::uint32_t sequence, double t_s) {
    clock_.set(from_seconds(t_s));
    camera_.hand_over({{&pixel_, 1, 1, 1}, from_seconds(t_s), sequence});
    return loop_.run_once();
  }

  std::uint8_t pixel_{};
  hal::MemoryCamera camera_;
  hal::ManualClock clock_;
  hal::LatestLink<FakeEstimate> link_;
  FakeTracker tracker_;
  hal::RunLoop<hal::MemoryCamera, hal::ManualClock, hal::LatestLink<FakeEstimate>, FakeTracker> loop_{
      camera_, clock_, link_, tracker_, kTimes};
};

TEST_F(RunLoop, GivesOneEstimateAFrameWithItsNumberAndCaptureTime) {
  EXPECT_EQ(show(7, 1.5), Tick::estimated);
  EXPECT_EQ(link_.published(), 1u);
  EXPECT_EQ(link_.latest().frame, 0u);
  EXPECT_EQ(link_.latest().t_capture, from_seconds(1.5));
  (void)show(9, 1.6);
  EXPECT_EQ(link_.latest().frame, 2u);  // counted from the first one, the dropped one included
}

TEST_F(RunLoop, RefusesDuplicatesAndFramesOutOfOrderWithoutAStepAndSpeaksAllTheSame) {
  (void)show(7, 1.5);
  EXPECT_EQ(show(7, 1.6), Tick::refused);  // the same number
  EXPECT_EQ(show(6, 1.6), Tick::refused);  // an older one
  EXPECT_EQ(show(8, 1.5), Tick::refused);  // the same stamp
  EXPECT_EQ(show(8, 1.4), Tick::refused);  // an older one
  EXPECT_EQ(tracker_.steps, 1);
  EXPECT_EQ(link_.published(), 5u);
  EXPECT_EQ(link_.latest().status, TrackingStatus::coasting);
  EXPECT_EQ(link_.latest().reason, Reason::stale_frame);
  EXPECT_EQ(loop_.counters().refused, 4u);
  EXPECT_EQ(show(8, 1.7), Tick::estimated);
}

TEST_F(RunLoop, RefusesAFrameOfTheFutureAndGoesOnWithTheNext) {
  (void)show(7, 1.5);
  camera_.hand_over({{&pixel_, 1, 1, 1}, from_seconds(99), 8});
  EXPECT_EQ(loop_.run_once(), Tick::refused);
  EXPECT_EQ(show(8, 1.6), Tick::estimated);
}

TEST_F(RunLoop, TakesACameraThatWasPluggedInAgainAndCountsFromZero) {
  (void)show(700, 1.5);
  EXPECT_EQ(loop_.run_once(), Tick::coasted);
  EXPECT_EQ(show(0, 2.0), Tick::estimated);
  EXPECT_EQ(show(0, 2.1), Tick::refused);
  EXPECT_EQ(link_.latest().frame, 1u);
}

TEST_F(RunLoop, CountsTheFramesThatAGapInTheSequenceSwallowed) {
  (void)show(7, 1.0);
  EXPECT_EQ(show(11, 1.2), Tick::estimated);
  EXPECT_EQ(loop_.counters().dropped, 3u);
}

TEST_F(RunLoop, GoesOnWhereTheSequenceWrapsRound) {
  (void)show(0xffffffffu, 1.0);
  EXPECT_EQ(show(1, 1.2), Tick::estimated);
  EXPECT_EQ(loop_.counters().dropped, 1u);
}

TEST_F(RunLoop, SpeaksAlsoWhenTheCameraIsSilent) {
  (void)show(7, 1.0);
  clock_.set(from_seconds(1.1));
  EXPECT_EQ(loop_.run_once(), Tick::coasted);
  EXPECT_EQ(link_.latest().status, TrackingStatus::coasting);
  EXPECT_EQ(link_.latest().frame, 0u);
  EXPECT_EQ(link_.latest().t_capture, from_seconds(1.1));
  EXPECT_EQ(loop_.counters().timeouts, 1u);
}

TEST_F(RunLoop, DegradesAfterTwoAndAHalfSilentPeriodsAndIsLostAfterTen) {
  (void)show(0, 1.0);
  const auto after = [this](double periods) {
    clock_.set(from_seconds(1.0 + 0.1 * periods));
    EXPECT_EQ(loop_.run_once(), Tick::coasted);
    return link_.latest();
  };
  EXPECT_EQ(after(2.4).status, TrackingStatus::coasting);
  EXPECT_EQ(link_.latest().reason, Reason::no_frame);
  EXPECT_EQ(after(2.6).status, TrackingStatus::degraded);
  EXPECT_EQ(link_.latest().reason, Reason::camera_stalled);
  EXPECT_TRUE(link_.latest().valid);
  EXPECT_EQ(after(9.9).status, TrackingStatus::degraded);
  EXPECT_EQ(after(10.1).status, TrackingStatus::lost);
  EXPECT_EQ(link_.latest().reason, Reason::camera_stalled);
  EXPECT_FALSE(link_.latest().valid);
  EXPECT_EQ(show(1, 3.0), Tick::estimated);
  EXPECT_EQ(link_.latest().status, TrackingStatus::tracking);
}

TEST_F(RunLoop, IsLostAtOnceWhenTheCameraIsUnplugged) {
  UnpluggedCamera unplugged;
  hal::RunLoop loop{unplugged, clock_, link_, tracker_, kTimes};
  EXPECT_EQ(loop.run_once(), Tick::failed);
  EXPECT_EQ(link_.latest().status, TrackingStatus::lost);
  EXPECT_EQ(link_.latest().reason, Reason::camera_gone);
  EXPECT_FALSE(link_.latest().valid);
}

TEST_F(RunLoop, FlagsAResultThatComesOutTooLate) {
  (void)show(0, 1.0);
  EXPECT_EQ(link_.latest().reason, Reason::none);
  clock_.set(from_seconds(1.3));
  camera_.hand_over({{&pixel_, 1, 1, 1}, from_seconds(1.1), 1});
  EXPECT_EQ(loop_.run_once(), Tick::estimated);
  EXPECT_EQ(link_.latest().reason, Reason::late_result);
  EXPECT_EQ(loop_.counters().late, 1u);
}

TEST_F(RunLoop, ReportsALinkThatFails) {
  BrokenLink broken;
  hal::RunLoop loop{camera_, clock_, broken, tracker_, kTimes};
  clock_.set(from_seconds(1));
  camera_.hand_over({{&pixel_, 1, 1, 1}, from_seconds(1), 0});
  EXPECT_EQ(loop.run_once(), Tick::failed);
  EXPECT_EQ(loop.counters().link_errors, 1u);
}

}  // namespace
}  // namespace articam
