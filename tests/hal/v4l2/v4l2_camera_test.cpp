#include "hal/v4l2/v4l2_camera.hpp"

#include <gtest/gtest.h>

#include "tests/hal/v4l2/camera_on_script.hpp"
#include "tests/support/heap_trap.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;
using test::kHeight_px, test::kStride, test::kWidth_px;

class V4l2Camera : public test::VideoCameraOnScript {};

TEST_F(V4l2Camera, LendsLumaInPlaceWithTheStrideOfTheDevice) {
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  EXPECT_EQ(device->format, V4L2_PIX_FMT_GREY);
  ASSERT_TRUE(device->complete(7));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_TRUE(std::ranges::any_of(device->memory, [&](auto& bytes) { return bytes.data() == frame.pixels.data; }));
  EXPECT_EQ(frame.pixels.stride_bytes, std::ptrdiff_t{kStride});
  EXPECT_EQ(frame.sequence, 7u);
  EXPECT_EQ(device->queued.size(), 3u);
  camera->release(frame);
  EXPECT_EQ(device->queued.size(), 4u);
}

TEST_F(V4l2Camera, CopiesLumaOutOfItsChroma) {
  device->formats = {V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_UYVY};
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  for (auto& bytes : device->memory) {
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = i % 2 == 1 ? 50 : 0;
  }
  ASSERT_TRUE(device->complete(1));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  for (int v = 0; v < kHeight_px; ++v) {
    for (int u = 0; u < kWidth_px; ++u) EXPECT_EQ(frame.pixels.row(v)[u], 50);
  }
  EXPECT_EQ(device->queued.size(), 4u);  // the device has its buffer back at once
  EXPECT_EQ(camera->counts().copied, 1u);
  camera->release(frame);
  EXPECT_EQ(device->queued.size(), 4u);
}

TEST_F(V4l2Camera, SaysWhyADeviceCannotBeTaken) {
  device->open_result = -EACCES;
  EXPECT_EQ(camera->start(), Status::io_error);
  EXPECT_TRUE(says("/dev/video0") && says("group video")) << camera->problem();
  device->open_result = -ENOENT;
  EXPECT_EQ(camera->start(), Status::no_device);
  device->open_result = 3;
  device->format_result = -EBUSY;
  EXPECT_EQ(camera->start(), Status::io_error);
  EXPECT_TRUE(says("another program"));
  device->capabilities = V4L2_CAP_VIDEO_CAPTURE_MPLANE | V4L2_CAP_STREAMING;
  EXPECT_EQ(camera->start(), Status::bad_argument);
  EXPECT_TRUE(says("multi-planar"));
  device->capabilities = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
  EXPECT_EQ(camera->start(), Status::bad_argument);
  device->capabilities = V4L2_CAP_VIDEO_CAPTURE;
  EXPECT_EQ(camera->start(), Status::bad_argument);
}

TEST_F(V4l2Camera, CopiesGreenOnlyWhereNothingBetterIsOfferedAndSaysSo) {
  device->formats = {V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_RGB24};
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  EXPECT_NE(camera->description().find("GREEN COPIED"), std::string::npos) << camera->description();
  for (auto& bytes : device->memory) {
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = i % 3 == 1 ? 50 : 0;
  }
  ASSERT_TRUE(device->complete(1));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  for (int u = 0; u < kWidth_px; ++u) EXPECT_EQ(frame.pixels.row(kHeight_px - 1)[u], 50);
}

TEST_F(V4l2Camera, GivesOutTheMiddleOfTheExposureWhicheverEndTheStampMarks) {
  for (const auto marks : {V4L2_BUF_FLAG_TSTAMP_SRC_SOE, V4L2_BUF_FLAG_TSTAMP_SRC_EOF}) {
    make({.exposure = 4000us, .readout = 10000us});
    device->settings[V4L2_CID_EXPOSURE_ABSOLUTE] = {1, 5000, 0};
    device->stamp_flags = std::uint32_t(V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | marks);
    const std::int64_t stamp_ns = (hal::MonotonicClock{}.now().ns / 1000 - 20'000) * 1000;  // V4L2 counts us
    const auto stamp = [&](v4l2_buffer& b) { device->set_stamp(b, stamp_ns); };
    device->on_stream = [&] { device->complete(0, [&](v4l2_buffer& b) { device->set_stamp(b, stamp_ns - 1000); }); };
    ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
    ASSERT_TRUE(device->complete(1, stamp));
    ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
    const bool at_start = marks == V4L2_BUF_FLAG_TSTAMP_SRC_SOE;
    EXPECT_EQ(frame.t_exposure.ns - stamp_ns, at_start ? 2'000'000 : -12'000'000);
    camera->release(frame);
  }
}

TEST_F(V4l2Camera, TakesTheNewestOfAllThatIsReadyAndGivesTheOthersBack) {
  ASSERT_EQ(camera->start(), Status::ok);
  for (std::uint32_t k = 1; k <= 4; ++k) ASSERT_TRUE(device->complete(k));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.sequence, 4u);
  EXPECT_EQ(camera->counts().overtaken, 3u);
  EXPECT_EQ(device->queued.size(), 3u);
  camera->release(frame);
}

TEST_F(V4l2Camera, RefusesCorruptAndShortFramesAndCountsThem) {
  ASSERT_EQ(camera->start(), Status::ok);
  expect_refused([](v4l2_buffer& b) { b.flags |= V4L2_BUF_FLAG_ERROR; });
  expect_refused([](v4l2_buffer& b) { b.bytesused = 0; });
  expect_refused([](v4l2_buffer& b) { b.bytesused = kStride * (kHeight_px - 1) + kWidth_px - 1; });
  EXPECT_EQ(camera->counts().corrupt, 1u);
  EXPECT_EQ(camera->counts().wrong_size, 2u);
}

TEST_F(V4l2Camera, RefusesToStartOnStampsOfAnotherClockAndSaysWhy) {
  device->stamp_flags = V4L2_BUF_FLAG_TIMESTAMP_UNKNOWN;
  EXPECT_EQ(camera->start(), Status::bad_argument);
  EXPECT_TRUE(says("CLOCK_MONOTONIC"));
  device->stamp_flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  const std::int64_t wall_clock_ns = 1'800'000'000'000'000'000;
  device->on_stream = [&] { device->complete(0, [&](v4l2_buffer& b) { device->set_stamp(b, wall_clock_ns); }); };
  EXPECT_EQ(camera->start(), Status::bad_argument);
  EXPECT_TRUE(says("CLOCK_MONOTONIC") && says("1800000000")) << camera->problem();
}

TEST_F(V4l2Camera, RefusesAStampThatJumpsWhileItRunsAndGoesOnWithTheNext) {
  ASSERT_EQ(camera->start(), Status::ok);
  expect_refused([](v4l2_buffer& b) { b.timestamp.tv_sec -= 3600; });
  expect_refused([](v4l2_buffer& b) { b.timestamp.tv_sec += 3600; });
  expect_refused([](v4l2_buffer& b) { b.flags &= ~std::uint32_t{V4L2_BUF_FLAG_TIMESTAMP_MASK}; });
  EXPECT_EQ(camera->counts().wrong_stamp, 3u);
  ASSERT_TRUE(device->complete(2));
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::ok);
  camera->release(frame);
}

TEST_F(V4l2Camera, RefusesAFrameThatIsNotLaterThanTheOneBeforeItAndGoesOnWithTheNext) {
  ASSERT_EQ(camera->start(), Status::ok);
  decltype(v4l2_buffer::timestamp) newest{};
  ASSERT_TRUE(device->complete(1, [&](v4l2_buffer& b) { newest = b.timestamp; }));
  ASSERT_TRUE(device->complete(2, [&](v4l2_buffer& b) { b.timestamp = newest; }));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.sequence, 1u) << "a stray takes nobody's place";
  camera->release(frame);
  expect_refused([&](v4l2_buffer& b) { device->set_stamp(b, hal::MonotonicClock{}.now().ns - 500'000'000); });
  EXPECT_EQ(camera->counts().out_of_order, 2u);
}

TEST_F(V4l2Camera, UnpluggedSaysSoAtOnceAndLivesAgainAfterANewStart) {
  ASSERT_EQ(camera->start(), Status::ok);
  device->unplugged = true;
  EXPECT_EQ(camera->acquire(frame, 10s), Status::no_device);
  EXPECT_TRUE(says("unplugged"));
  EXPECT_EQ(camera->start(), Status::no_device);
  device->unplugged = false;
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(0));
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::ok);
  camera->release(frame);
}

TEST_F(V4l2Camera, ThatNoLongerTakesItsBuffersEndsAsIfUnplugged) {
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(1));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  device->takes_buffers = false;
  camera->release(frame);
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
}

TEST_F(V4l2Camera, GivesEverythingBackOnStopAndAfterAStartThatFailed) {
  device->on_stream = [] {};
  EXPECT_EQ(camera->start(), Status::timeout);
  EXPECT_TRUE(says("no frame")) << camera->problem();
  EXPECT_EQ(device->unmaps, device->maps);
  EXPECT_EQ(device->closes, 1);
  device->on_stream = [this] { device->complete(0); };
  ASSERT_EQ(camera->start(), Status::ok);
  camera->stop();
  camera->stop();
  EXPECT_EQ(device->maps, 2 * test::ScriptedVideoDevice::kBuffers);
  EXPECT_EQ(device->unmaps, device->maps);
  EXPECT_EQ(device->closes, 2);
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
}

TEST_F(V4l2Camera, NeverCallsTheHeapBetweenStartAndStop) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  const std::function<void(v4l2_buffer&)> corrupt = [](v4l2_buffer& b) { b.flags |= V4L2_BUF_FLAG_ERROR; };
  for (const std::uint32_t format : {V4L2_PIX_FMT_NV12, V4L2_PIX_FMT_YUYV}) {
    device->formats = {format};
    ASSERT_EQ(camera->start(), Status::ok);
    int taken = 0;
    const test::HeapTrap trap;
    for (std::uint32_t k = 0; k < 400; k += 4) {
      (void)device->complete(k);
      (void)device->complete(k + 1, corrupt);
      (void)device->complete(k + 2);
      taken += camera->acquire(frame, 0ms) == Status::ok;
      camera->release(frame);
      (void)camera->acquire(frame, 0ms);  // a timeout
    }
    EXPECT_EQ(trap.calls(), 0);
    EXPECT_EQ(taken, 100);
  }
}

TEST(SystemVideoCalls, SayWhatIsMissing) {
  hal::V4l2Camera camera{{.device = "/dev/no-such-camera", .width_px = kWidth_px, .height_px = kHeight_px}};
  EXPECT_EQ(camera.start(), Status::no_device);
  EXPECT_EQ(camera.problem(), "/dev/no-such-camera: it could not be opened: No such file or directory");
  hal::V4l2Camera no_video{{.device = "/dev/null", .width_px = kWidth_px, .height_px = kHeight_px}};
  EXPECT_EQ(no_video.start(), Status::io_error);  // the kernel answers ENOTTY
  EXPECT_NE(no_video.problem().find("be asked what it can do"), std::string_view::npos);
}

}  // namespace
}  // namespace articam
