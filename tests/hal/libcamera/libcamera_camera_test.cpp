#include "hal/libcamera/libcamera_camera.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/hal/libcamera/scripted_device.hpp"
#include "tests/support/heap_trap.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;
using Health = hal::CompletedBuffer::Health;

constexpr int kWidth_px = 16, kHeight_px = 8;

class LibcameraCamera : public testing::Test {
 protected:
  void make(hal::LibcameraOptions options = {}) {
    if (options.width_px == 0) options.width_px = kWidth_px;
    options.height_px = kHeight_px;
    options.first_frame_wait = 20ms;
    auto owned = std::make_unique<test::ScriptedDevice>();
    device = owned.get();
    camera = std::make_unique<hal::LibcameraCamera>(options, std::move(owned));
  }
  void SetUp() override { make(); }

  /// What start says of a stream that differs so from what was asked for.
  Status start_with(const std::function<void(hal::Stream&)>& bend) {
    device->bend_stream = bend;
    return camera->start();
  }
  bool says(std::string_view words) const { return camera->problem().find(words) != std::string_view::npos; }

  /// A bad buffer comes back: nobody sees it, and the camera may write into it again.
  void expect_refused(const std::function<void(hal::CompletedBuffer&)>& bend) {
    const std::size_t free_buffers = device->queued.size();
    ASSERT_TRUE(device->complete(1, bend));
    frame = {};
    EXPECT_EQ(camera->acquire(frame, 0ms), Status::timeout);
    EXPECT_EQ(frame.pixels.data, nullptr);
    EXPECT_EQ(device->queued.size(), free_buffers);
  }

  test::ScriptedDevice* device{};
  std::unique_ptr<hal::LibcameraCamera> camera;
  hal::Frame frame;
};

TEST_F(LibcameraCamera, ThatDoesNotExistIsRefusedWithTheReason) {
  make({.camera = "side"});
  EXPECT_EQ(camera->start(), Status::no_device);
  EXPECT_TRUE(says("'side'") && says("0: front")) << camera->problem();
}

TEST_F(LibcameraCamera, LendsLumaInPlaceWithTheStrideOfTheCamera) {
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(7));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_TRUE(std::ranges::any_of(device->memory, [&](auto& bytes) { return bytes.data() == frame.pixels.data; }));
  EXPECT_EQ(frame.pixels.stride_bytes, kWidth_px * 4 + 32);
  EXPECT_EQ(frame.sequence, 7u);
  EXPECT_EQ(device->queued.size(), 3u);  // the lent buffer is not the camera's
  camera->release(frame);
  EXPECT_EQ(device->queued.size(), 4u);
  EXPECT_EQ(camera->counts().copied, 0u);
}

TEST_F(LibcameraCamera, CopiesGreenOnlyWhereNothingBetterIsOfferedAndSaysSo) {
  device->abilities.formats = {hal::fourcc("MJPG"), hal::fourcc("BG24")};
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  EXPECT_NE(camera->description().find("GREEN COPIED"), std::string::npos) << camera->description();
  for (auto& bytes : device->memory) {
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = i % 3 == 1 ? 50 : 0;  // rows are not a multiple of 3
  }
  ASSERT_TRUE(device->complete(1));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.pixels.stride_bytes, kWidth_px);
  for (int u = 0; u < kWidth_px; ++u) EXPECT_EQ(frame.pixels.row(0)[u], 50);
  EXPECT_EQ(device->queued.size(), 4u);  // the camera has its buffer back at once
  EXPECT_EQ(camera->counts().copied, 1u);
}

TEST_F(LibcameraCamera, RefusesAFormatWithoutEightBitLumaOrGreen) {
  device->abilities.formats = {hal::fourcc("MJPG"), hal::fourcc("R10 ")};
  EXPECT_EQ(camera->start(), Status::bad_argument);
  EXPECT_TRUE(says("no 8-bit format"));
}

TEST_F(LibcameraCamera, RefusesAStreamOfAnotherSizeFormatOrStrideBeforeItRuns) {
  const auto never = [] { FAIL() << "the capture ran"; };
  device->on_start = never;
  EXPECT_EQ(start_with([](hal::Stream& s) { s.width_px = 32; }), Status::bad_argument);
  EXPECT_TRUE(says("32 x 8") && says("16 x 8")) << camera->problem();
  EXPECT_EQ(start_with([](hal::Stream& s) { s.format = hal::fourcc("YUYV"); }), Status::bad_argument);
  EXPECT_TRUE(says("format"));
  EXPECT_EQ(start_with([](hal::Stream& s) { s.stride_bytes = kWidth_px - 1; }), Status::bad_argument);
  EXPECT_TRUE(says("rows"));
  EXPECT_EQ(start_with([](hal::Stream& s) { s.stride_bytes *= 2; }), Status::bad_argument);
  EXPECT_TRUE(says("too short for the image"));
  EXPECT_EQ(start_with([](hal::Stream& s) { s.buffers.resize(1); }), Status::bad_argument);
  EXPECT_TRUE(says("two buffers"));
}

TEST_F(LibcameraCamera, RefusesAnImageBeyondWhatTheProgramIsBuiltForBeforeItLooksForACamera) {
  for (const int width_px : {-1, kMaxImageWidth_px + 1}) {
    make({.width_px = width_px});
    EXPECT_EQ(camera->start(), Status::bad_argument);
    EXPECT_TRUE(says("beyond")) << camera->problem();
    EXPECT_TRUE(device->opened.empty());
  }
}

TEST_F(LibcameraCamera, PassesOnWhatTheOptionsFixAndSaysWhereThePeriodIsNotKept) {
  make({.camera = "back", .period = 33333us, .exposure = 4000us, .gain = 2.0});
  device->abilities.exposure_us = {100, 30000};
  device->abilities.gain = {1, 8};
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  EXPECT_EQ(device->opened, "back");
  EXPECT_EQ(device->controls.exposure_us, 4000);
  EXPECT_EQ(device->controls.gain, 2.0f);
  EXPECT_NE(camera->description().find("the camera's own"), std::string::npos);
  device->abilities.period_us = {8000, 1e6};
  ASSERT_EQ(camera->start(), Status::ok);
  EXPECT_EQ(device->controls.period_us, 33333);
  EXPECT_EQ(camera->description().find("the camera's own"), std::string::npos);
}

TEST_F(LibcameraCamera, GivesOutTheMiddleOfTheExposureWhicheverEndTheStampMarks) {
  constexpr std::int64_t kExposure_ns = 10'000'000;
  for (const auto marks : {hal::StampMarks::exposure_start, hal::StampMarks::readout_start}) {
    make({.stamp = marks});
    device->exposure_ns = kExposure_ns;
    std::int64_t stamp_ns = 0;
    const auto stamp = [&](hal::CompletedBuffer& b) { stamp_ns = b.stamp.ns -= 2 * kExposure_ns; };
    device->on_start = [&] { device->complete(0, stamp); };
    ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
    ASSERT_TRUE(device->complete(1, stamp));
    ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
    const std::int64_t half = kExposure_ns / 2;
    EXPECT_EQ(frame.t_exposure.ns - stamp_ns, marks == hal::StampMarks::exposure_start ? half : -half);
    camera->release(frame);
  }
}

TEST_F(LibcameraCamera, TakesTheExposureThatWasAskedForWhereTheCameraDoesNotTellIt) {
  make({.exposure = 4000us});
  device->abilities.exposure_us = {100, 30000};
  std::int64_t stamp_ns = 0;
  const auto stamp = [&](hal::CompletedBuffer& b) { stamp_ns = b.stamp.ns -= 10'000'000, b.exposure_ns = 0; };
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  ASSERT_TRUE(device->complete(1, stamp));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.t_exposure.ns - stamp_ns, 2'000'000);
  camera->release(frame);
}

TEST_F(LibcameraCamera, NeverDatesAFrameIntoTheFuture) {
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(1, [](auto& b) { b.exposure_ns = 900'000'000; }));  // stamped now
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_LE(frame.t_exposure, hal::MonotonicClock{}.now());
  camera->release(frame);
}

TEST_F(LibcameraCamera, TheNewestFrameWinsAndTheOthersAreCountedAndGivenBack) {
  ASSERT_EQ(camera->start(), Status::ok);
  for (std::uint32_t k = 1; k <= 100; ++k) ASSERT_TRUE(device->complete(k));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.sequence, 100u);
  EXPECT_EQ(camera->counts().overtaken, 99u);
  EXPECT_EQ(device->queued.size(), 3u);
  camera->release(frame);
}

TEST_F(LibcameraCamera, RefusesCancelledCorruptAndUnsettledFramesAndCountsThem) {
  ASSERT_EQ(camera->start(), Status::ok);
  expect_refused([](auto& b) { b.health = Health::cancelled; });
  expect_refused([](auto& b) { b.health = Health::corrupt; });
  expect_refused([](auto& b) { b.health = Health::starting_up; });
  const auto counts = camera->counts();
  EXPECT_EQ(counts.cancelled, 1u);
  EXPECT_EQ(counts.corrupt, 1u);
  EXPECT_EQ(counts.starting_up, 1u);
}

TEST_F(LibcameraCamera, RefusesAFrameThatIsShorterThanTheImage) {
  ASSERT_EQ(camera->start(), Status::ok);
  const std::size_t enough = (kWidth_px * 4 + 32) * (kHeight_px - 1) + kWidth_px;  // no padding after the last row
  expect_refused([&](auto& b) { b.bytes_used = enough - 1; });
  expect_refused([&](auto& b) { b.bytes_used = 0; });
  EXPECT_EQ(camera->counts().wrong_size, 2u);
  ASSERT_TRUE(device->complete(2, [&](auto& b) { b.bytes_used = enough; }));
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::ok);
  camera->release(frame);
}

TEST_F(LibcameraCamera, RefusesToStartOnStampsOfAnotherClockAndSaysWhy) {
  for (const std::int64_t off_ns : {std::int64_t{-5'000'000'000}, std::int64_t{60'000'000'000}}) {
    device->on_start = [&] { device->complete(0, [&](auto& b) { b.stamp.ns += off_ns; }); };
    EXPECT_EQ(camera->start(), Status::bad_argument);
    EXPECT_TRUE(says("CLOCK_MONOTONIC")) << camera->problem();
    EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
  }
}

TEST_F(LibcameraCamera, RefusesAStampThatJumpsWhileItRunsAndGoesOnWithTheNext) {
  ASSERT_EQ(camera->start(), Status::ok);
  expect_refused([](auto& b) { b.stamp.ns -= 3'600'000'000'000; });
  expect_refused([](auto& b) { b.stamp.ns += 3'600'000'000'000; });
  expect_refused([](auto& b) { b.stamp.ns = INT64_MIN; });
  expect_refused([](auto& b) { b.exposure_ns = -1; });
  expect_refused([](auto& b) { b.exposure_ns = INT64_MAX; });
  EXPECT_EQ(camera->counts().wrong_stamp, 5u);
  ASSERT_TRUE(device->complete(2));
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::ok);
  camera->release(frame);
}

TEST_F(LibcameraCamera, ThatStaysSilentAfterItsStartIsGivenBack) {
  device->on_start = [] {};
  EXPECT_EQ(camera->start(), Status::timeout);
  EXPECT_TRUE(says("20 ms"));
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
}

TEST_F(LibcameraCamera, UnpluggedSaysSoAtOnceAndLivesAgainAfterANewStart) {
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(7));
  device->unplug();
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
  EXPECT_TRUE(says("unplugged"));
  EXPECT_EQ(camera->start(), Status::no_device);
  device->plugged_in = true;
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(0));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.sequence, 0u);
  camera->release(frame);
}

TEST_F(LibcameraCamera, ThatNoLongerTakesItsBuffersEndsAsIfUnplugged) {
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(1));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  device->refuses_buffers = true;
  camera->release(frame);
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
}

TEST_F(LibcameraCamera, StopsInAnyStateAndLendsNothingAfterwards) {
  camera->stop();
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(1));
  camera->stop();
  camera->stop();
  EXPECT_TRUE(device->queued.empty());  // what the stop cancelled is not queued again
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
  EXPECT_EQ(camera->counts().cancelled, 0u);  // a stop is no fault
}

TEST_F(LibcameraCamera, StopsExceptionsOfTheLibraryWithTheirWords) {
  device->on_start = [] { throw std::runtime_error{"the pipeline broke"}; };
  EXPECT_EQ(camera->start(), Status::io_error);
  EXPECT_TRUE(says("the pipeline broke"));
  device->on_start = [] { throw 7; };
  EXPECT_EQ(camera->start(), Status::io_error);
  EXPECT_FALSE(camera->problem().empty());
}

TEST_F(LibcameraCamera, NeverCallsTheHeapBetweenStartAndStop) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  const std::function<void(hal::CompletedBuffer&)> corrupt = [](auto& b) { b.health = Health::corrupt; };
  for (const auto format : {hal::fourcc("NV12"), hal::fourcc("YUYV")}) {
    device->abilities.formats = {format};
    ASSERT_EQ(camera->start(), Status::ok);
    int taken = 0;
    const test::HeapTrap trap;
    for (std::uint32_t k = 0; k < 400; k += 4) {
      (void)device->complete(k);
      (void)device->complete(k + 1, corrupt);
      (void)device->complete(k + 2);  // overtakes the first
      taken += camera->acquire(frame, 0ms) == Status::ok;
      camera->release(frame);
      (void)camera->acquire(frame, 0ms);  // a timeout
    }
    device->unplug();
    (void)camera->acquire(frame, 0ms);
    EXPECT_EQ(trap.calls(), 0);
    EXPECT_EQ(taken, 100);
    device->plugged_in = true;
  }
}

}  // namespace
}  // namespace articam
