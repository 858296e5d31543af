#include "hal/libcamera/libcamera_camera.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/hal/libcamera/camera_on_script.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;
using Health = hal::CompletedBuffer::Health;
using test::kHeight_px, test::kWidth_px;

class LibcameraCamera : public test::CameraOnScript {};

TEST_F(LibcameraCamera, ThatDoesNotExistIsRefusedWithTheReason) {
  make({.camera = "side"});
  EXPECT_EQ(camera->start(), Status::no_device);
  EXPECT_TRUE(says("'side'") && says("0: front")) << camera->problem();
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
  EXPECT_NE(camera->warning().find("keeps its own"), std::string::npos) << camera->warning();
  device->abilities.period_us = {8000, 1e6};
  ASSERT_EQ(camera->start(), Status::ok);
  EXPECT_EQ(device->controls.period_us, 33333);
  EXPECT_EQ(camera->warning(), "");
}

/// Run under a thread sanitizer, too: camera, loop and requeuer touch the same buffers.
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

TEST_F(LibcameraCamera, ThatNoLongerTakesItsBuffersEndsAndSaysThatItWasThat) {
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(1));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  device->refuses_buffers = true;
  camera->release(frame);
  EXPECT_EQ(camera->acquire(frame, 10s), Status::no_device);
  EXPECT_TRUE(says("a buffer could not be given back")) << camera->problem();
  device->unplug();  // which was the cause, told late
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
  EXPECT_TRUE(says("unplugged")) << camera->problem();
}

TEST_F(LibcameraCamera, StopsInAnyStateAndLendsNothingAfterwards) {
  camera->stop();
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(1));
  camera->stop();
  camera->stop();
  EXPECT_TRUE(device->has_free(0));  // what the stop cancelled is not queued again
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

}  // namespace
}  // namespace articam
