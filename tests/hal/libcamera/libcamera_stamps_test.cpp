/// @file  From the library's time stamps to the middle of an exposure, and the stamps that are refused.

#include "hal/libcamera/libcamera_camera.hpp"

#include <gtest/gtest.h>

#include "tests/hal/libcamera/camera_on_script.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;

class LibcameraStamps : public test::CameraOnScript {};

TEST_F(LibcameraStamps, GivesOutTheMiddleOfTheExposureWhicheverEndTheStampMarks) {
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

TEST_F(LibcameraStamps, TakesTheExposureThatWasAskedForWhereTheCameraDoesNotTellIt) {
  make({.exposure = 4000us});
  device->abilities.exposure_us = {100, 30000};
  std::int64_t stamp_ns = 0;
  const auto stamp = [&](hal::CompletedBuffer& b) { stamp_ns = b.stamp.ns -= 10'000'000, b.exposure_ns = 0; };
  device->on_start = [&] { device->complete(0, stamp); };
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  ASSERT_TRUE(device->complete(1, stamp));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.t_exposure.ns - stamp_ns, 2'000'000);
  camera->release(frame);
}

TEST_F(LibcameraStamps, TakesTheStampForTheReadoutWhereEachFrameTellsItsExposureAndForItsStartWhereNot) {
  for (const std::int64_t told_ns : {std::int64_t{8'000'000}, std::int64_t{0}}) {
    make({.exposure = 4000us});
    device->abilities.exposure_us = {100, 30000};
    std::int64_t stamp_ns = 0;
    const auto stamp = [&](hal::CompletedBuffer& b) { stamp_ns = b.stamp.ns -= 10'000'000, b.exposure_ns = told_ns; };
    device->on_start = [&] { device->complete(0, stamp); };
    ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
    ASSERT_TRUE(device->complete(1, stamp));
    ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
    EXPECT_EQ(frame.t_exposure.ns - stamp_ns, told_ns != 0 ? -told_ns / 2 : 2'000'000);
    camera->release(frame);
  }
}

TEST_F(LibcameraStamps, RefusesAFrameThatIsNotLaterThanTheOneBeforeItAndGoesOnWithTheNext) {
  ASSERT_EQ(camera->start(), Status::ok);
  Timestamp newest;
  ASSERT_TRUE(device->complete(1, [&](auto& b) { newest = b.stamp; }));
  ASSERT_TRUE(device->complete(2, [&](auto& b) { b.stamp = newest; }));
  ASSERT_TRUE(device->complete(3, [&](auto& b) { b.stamp = {newest.ns - 1}; }));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.sequence, 1u) << "a late stray takes nobody's place";
  camera->release(frame);
  EXPECT_EQ(camera->counts().out_of_order, 2u);
  ASSERT_TRUE(device->complete(4));
  EXPECT_EQ(camera->acquire(frame, 0ms), Status::ok);
  camera->release(frame);
}

TEST_F(LibcameraStamps, NeverDatesAFrameIntoTheFuture) {
  make({.stamp = hal::StampMarks::exposure_start});
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(1, [](auto& b) { b.exposure_ns = 900'000'000; }));  // stamped now
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_LE(frame.t_exposure, hal::MonotonicClock{}.now());
  camera->release(frame);
}

TEST_F(LibcameraStamps, RefusesToStartOnStampsOfAnotherClockAndSaysWhy) {
  for (const std::int64_t off_ns : {std::int64_t{-5'000'000'000}, std::int64_t{60'000'000'000}}) {
    device->on_start = [&] { device->complete(0, [&](auto& b) { b.stamp.ns += off_ns; }); };
    EXPECT_EQ(camera->start(), Status::bad_argument);
    EXPECT_TRUE(says("CLOCK_MONOTONIC")) << camera->problem();
    EXPECT_EQ(camera->acquire(frame, 0ms), Status::no_device);
  }
}

TEST_F(LibcameraStamps, RefusesAStampThatJumpsWhileItRunsAndGoesOnWithTheNext) {
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

}  // namespace
}  // namespace articam
