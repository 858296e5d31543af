#include "hal/supervision/supervised_camera.hpp"

#include <gtest/gtest.h>

#include "hal/memory/latest_link.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/run_loop.hpp"
#include "tests/hal/supervision/moody_camera.hpp"
#include "tests/support/fake_tracker.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;
using Mood = test::MoodyCamera::Mood;

constexpr auto kPeriod = 10ms;
constexpr hal::SupervisionOptions kHasty{.period = kPeriod, .first_pause = 1ms, .longest_pause = 4ms};

/// Time passes for the supervisor only as the test winds the clock; the pauses between attempts are real, and short.
class SupervisedCamera : public testing::Test {
 protected:
  using Supervised = hal::SupervisedCamera<test::MoodyCamera, hal::ManualClock>;

  Status tick() {
    clock.set({clock.now().ns + std::chrono::nanoseconds{kPeriod}.count()});
    hal::Frame frame;
    const Status status = supervised.acquire(frame, 1ms);
    if (status == Status::ok) supervised.release(frame);
    return status;
  }
  /// Ticks until a frame comes; bounded, so that a dead camera fails instead of hanging.
  bool recovers() {
    for (int i = 0; i < 10'000; ++i) {
      if (tick() == Status::ok) return true;
    }
    return false;
  }
  void TearDown() override {
    supervised.stop();
    EXPECT_EQ(camera.touched_at_once, 0);
    EXPECT_EQ(camera.leaked, 0);
  }

  test::MoodyCamera camera;
  hal::ManualClock clock;
  Supervised supervised{camera, clock, kHasty};
};

TEST_F(SupervisedCamera, PassesOnTheFramesOfACameraThatWorks) {
  ASSERT_EQ(supervised.start(), Status::ok);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(tick(), Status::ok);
  EXPECT_EQ(camera.starts, 1);
  EXPECT_EQ(supervised.counts().restarts, 0u);
}

TEST_F(SupervisedCamera, ReportsACameraThatIsMissingAtTheStartAndTriesNoMore) {
  camera.mood = Mood::unplugged;
  EXPECT_EQ(supervised.start(), Status::no_device);
  EXPECT_EQ(camera.starts, 1);
}

TEST_F(SupervisedCamera, IsBackAfterItWasUnpluggedAndPluggedInAgain) {
  ASSERT_EQ(supervised.start(), Status::ok);
  for (std::uint64_t round = 1; round <= 3; ++round) {
    ASSERT_EQ(tick(), Status::ok);
    camera.mood = Mood::unplugged;
    EXPECT_EQ(tick(), Status::no_device);  // at once
    EXPECT_TRUE(supervised.restarting());
    while (supervised.counts().failed_attempts < 3 * round) EXPECT_EQ(tick(), Status::no_device);
    camera.mood = Mood::gives;
    EXPECT_TRUE(recovers());
    EXPECT_EQ(supervised.counts().restarts, round);
  }
}

TEST_F(SupervisedCamera, IsStartedAnewAfterTenSilentPeriodsAndNotBefore) {
  ASSERT_EQ(supervised.start(), Status::ok);
  ASSERT_EQ(tick(), Status::ok);
  camera.mood = Mood::silent;
  for (int i = 1; i < 10; ++i) EXPECT_EQ(tick(), Status::timeout);
  EXPECT_FALSE(supervised.restarting());
  EXPECT_EQ(tick(), Status::timeout);
  EXPECT_TRUE(supervised.restarting());
  camera.mood = Mood::gives;
  EXPECT_TRUE(recovers());
  EXPECT_EQ(camera.starts, 2);
}

TEST_F(SupervisedCamera, ThatGivesNothingButBrokenFramesIsSilentToo) {
  ASSERT_EQ(supervised.start(), Status::ok);
  camera.mood = Mood::broken_frames;
  for (int i = 1; i <= 10; ++i) EXPECT_EQ(tick(), Status::io_error);
  EXPECT_TRUE(supervised.restarting());
  camera.mood = Mood::gives;
  EXPECT_TRUE(recovers());
}

TEST_F(SupervisedCamera, KeepsTheLoopSpeakingWhileItsStartTakesLong) {
  test::FakeTracker tracker;
  hal::MonotonicClock now;
  hal::SupervisedCamera watched{camera, now, kHasty};
  hal::LatestLink<test::FakeEstimate> link;
  hal::RunLoop loop{watched, now, link, tracker, {.period = 1ms}};
  ASSERT_EQ(loop.start(), Status::ok);
  EXPECT_EQ(loop.run_once(), hal::Tick::estimated);
  camera.mood = Mood::unplugged;
  camera.starts_slowly = true;  // the attempt hangs until further notice
  for (int i = 0; i < 50; ++i) EXPECT_EQ(loop.run_once(), hal::Tick::failed);
  EXPECT_EQ(link.published(), 51u);
  EXPECT_EQ(loop.counters().camera_errors, 50u);
  camera.mood = Mood::gives;
  camera.starts_slowly = false;
  hal::Tick tick{};
  for (int i = 0; i < 10'000 && tick != hal::Tick::estimated; ++i) tick = loop.run_once();
  EXPECT_EQ(tick, hal::Tick::estimated);  // counts from zero again, and the loop takes it
  watched.stop();
}

TEST_F(SupervisedCamera, StopsWhileItIsBeingStartedAnewAndInThePauseBetweenAttempts) {
  for (int round = 0; round < 20; ++round) {
    camera.mood = Mood::gives;
    ASSERT_EQ(supervised.start(), Status::ok);
    camera.mood = Mood::unplugged;
    EXPECT_EQ(tick(), Status::no_device);
    const auto attempts = supervised.counts().failed_attempts;
    while (round % 2 == 1 && supervised.counts().failed_attempts == attempts) std::this_thread::yield();
    supervised.stop();
    EXPECT_FALSE(supervised.restarting());
  }
}

TEST(SupervisionOptions, DoubleThePauseUpToOneSecondSoThatAReplugIsSeenWithinTwo) {
  constexpr hal::SupervisionOptions kDefault{.period = kPeriod};
  auto pause = kDefault.first_pause;
  EXPECT_EQ(pause, 100ms);
  for (const auto expected : {200ms, 400ms, 800ms, 1000ms, 1000ms}) {
    pause = longer_pause(pause, kDefault);
    EXPECT_EQ(pause, expected);
  }
}

}  // namespace
}  // namespace articam
