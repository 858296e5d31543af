/// @file  What goes wrong with cameras and their clocks in the field, from the driver up to what the loop publishes.

#include <gtest/gtest.h>

#include "hal/libcamera/libcamera_camera.hpp"
#include "hal/memory/latest_link.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/run_loop.hpp"
#include "hal/supervision/supervised_camera.hpp"
#include "tests/hal/libcamera/scripted_device.hpp"
#include "tests/support/fake_tracker.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;
using hal::Tick;
using test::FakeEstimate;
using test::FakeTracker;
using Health = hal::CompletedBuffer::Health;

constexpr hal::SupervisionOptions kHasty{.period = 2ms, .first_pause = 1ms, .longest_pause = 2ms};

class CameraFault : public testing::Test {
 protected:
  using Supervised = hal::SupervisedCamera<hal::LibcameraCamera, hal::MonotonicClock>;

  CameraFault() {
    auto owned = std::make_unique<test::ScriptedDevice>();
    device = owned.get();
    device->first_sequence = 100;
    camera = std::make_unique<hal::LibcameraCamera>(
        hal::LibcameraOptions{.width_px = 16, .height_px = 8, .first_frame_wait = 100ms}, std::move(owned));
    supervised = std::make_unique<Supervised>(*camera, clock, kHasty);
    loop = std::make_unique<Loop>(*supervised, clock, link, tracker, hal::LoopTimes{.period = 2ms});
    EXPECT_EQ(loop->start(), Status::ok);
  }

  Tick show(std::uint32_t sequence, const std::function<void(hal::CompletedBuffer&)>& bend = {}) {
    EXPECT_TRUE(device->complete(sequence, bend));
    return loop->run_once();
  }

  /// Whatever comes back, the tracker does not see it, something is published, and the next good frame is taken.
  void expect_refused_before_the_tracker(const std::function<void(hal::CompletedBuffer&)>& bend) {
    ASSERT_EQ(show(next, {}), Tick::estimated);
    const int steps = tracker.steps;
    const auto published = link.published();
    EXPECT_EQ(show(next + 1, bend), Tick::coasted);
    EXPECT_EQ(tracker.steps, steps);
    EXPECT_EQ(link.published(), published + 1);
    EXPECT_EQ(show(next + 2, {}), Tick::estimated);
    next += 3;
  }

  /// Ticks until the camera was started anew; bounded, so that a dead one fails instead of hanging.
  bool is_started_anew() {
    for (int i = 0; i < 10'000 && supervised->counts().restarts == 0; ++i) (void)loop->run_once();
    (void)loop->run_once();  // takes it over
    return !supervised->restarting();
  }

  using Loop = hal::RunLoop<Supervised, hal::MonotonicClock, hal::LatestLink<FakeEstimate>, FakeTracker>;
  std::uint32_t next{101};
  test::ScriptedDevice* device{};
  hal::MonotonicClock clock;
  hal::LatestLink<FakeEstimate> link;
  FakeTracker tracker;
  std::unique_ptr<hal::LibcameraCamera> camera;
  std::unique_ptr<Supervised> supervised;
  std::unique_ptr<Loop> loop;
};

TEST_F(CameraFault, AGapInTheSequenceIsCountedAndTheTrueTimeIsUsed) {
  ASSERT_EQ(show(101), Tick::estimated);
  Timestamp stamp;
  ASSERT_EQ(show(105, [&](auto& b) { stamp = b.stamp; }), Tick::estimated);
  EXPECT_EQ(loop->counters().dropped, 3u);
  EXPECT_EQ(link.latest().frame, 4u);
  EXPECT_EQ(link.latest().t_capture, stamp);
}

TEST_F(CameraFault, ADuplicateOrLateFrameIsRefusedWithoutAStep) {
  Timestamp stamp;
  ASSERT_EQ(show(105, [&](auto& b) { stamp = b.stamp; }), Tick::estimated);
  EXPECT_EQ(show(105), Tick::refused);
  EXPECT_EQ(show(104), Tick::refused);
  // By its stamp the camera refuses it already, before it can take the place of a good one.
  EXPECT_EQ(show(106, [&](auto& b) { b.stamp = stamp; }), Tick::coasted);
  EXPECT_EQ(show(106, [&](auto& b) { b.stamp.ns = stamp.ns - 1; }), Tick::coasted);
  EXPECT_EQ(tracker.steps, 1);
  EXPECT_EQ(loop->counters().refused, 2u);
  EXPECT_EQ(camera->counts().out_of_order, 2u);
  EXPECT_EQ(link.published(), 5u);
  EXPECT_EQ(show(107), Tick::estimated);
}

TEST_F(CameraFault, ACorruptFrameIsDiscardedBeforeAPixelIsRead) {
  expect_refused_before_the_tracker([](auto& b) { b.health = Health::corrupt; });
}
TEST_F(CameraFault, ACancelledFrameIsDiscardedBeforeAPixelIsRead) {
  expect_refused_before_the_tracker([](auto& b) { b.health = Health::cancelled; });
}
TEST_F(CameraFault, AShortFrameIsDiscardedBeforeAPixelIsRead) {
  expect_refused_before_the_tracker([](auto& b) { b.bytes_used = 1; });
}
TEST_F(CameraFault, AStampThatJumpsForwardIsNotIntegrated) {
  expect_refused_before_the_tracker([](auto& b) { b.stamp.ns += 3'600'000'000'000; });
}
TEST_F(CameraFault, AStampThatJumpsBackIsNotIntegrated) {
  expect_refused_before_the_tracker([](auto& b) { b.stamp.ns -= 3'600'000'000'000; });
}

TEST_F(CameraFault, AnUnpluggedCameraIsReportedAtOnceAndTrackedAgainAfterTheReplug) {
  ASSERT_EQ(show(101), Tick::estimated);
  device->first_sequence = 0;  // it counts anew
  device->unplug();
  for (std::uint64_t ticks = 1; ticks <= 5; ++ticks) {
    EXPECT_EQ(loop->run_once(), Tick::failed);
    EXPECT_EQ(link.published(), 1 + ticks);
  }
  device->plugged_in = true;
  ASSERT_TRUE(is_started_anew());
  EXPECT_EQ(show(1), Tick::estimated);
  EXPECT_EQ(loop->counters().dropped, 0u);
}

TEST_F(CameraFault, AStalledCameraIsStartedAnewWhileEveryTickSpeaks) {
  ASSERT_EQ(show(101), Tick::estimated);
  ASSERT_TRUE(is_started_anew());  // no frame comes: ten periods of silence
  EXPECT_EQ(loop->counters().timeouts + 1, link.published());
  EXPECT_EQ(show(101), Tick::estimated);  // the number that it had before: after a silence it may count anew
}

}  // namespace
}  // namespace articam
