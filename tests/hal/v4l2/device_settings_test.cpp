#include "hal/v4l2/device_settings.hpp"

#include <gtest/gtest.h>

#include "tests/hal/v4l2/camera_on_script.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;
using test::kHeight_px, test::kStride, test::kWidth_px;

class DeviceSettings : public test::VideoCameraOnScript {};

TEST_F(DeviceSettings, RefusesAnotherSizeFormatStrideOrBufferLengthBeforeItStreams) {
  device->on_stream = [] { FAIL() << "the capture ran"; };
  EXPECT_EQ(start_with([](v4l2_pix_format& f) { f.width = 32; }), Status::bad_argument);
  EXPECT_TRUE(says("32 x 8") && says("16 x 8")) << camera->problem();
  EXPECT_EQ(start_with([](v4l2_pix_format& f) { f.pixelformat = V4L2_PIX_FMT_MJPEG; }), Status::bad_argument);
  EXPECT_EQ(start_with([](v4l2_pix_format& f) { f.field = V4L2_FIELD_INTERLACED; }), Status::bad_argument);
  EXPECT_EQ(start_with([](v4l2_pix_format& f) { f.bytesperline = kWidth_px - 1; }), Status::bad_argument);
  EXPECT_TRUE(says("rows"));
  device->buffer_length = kStride * (kHeight_px - 1) + kWidth_px - 1;
  EXPECT_EQ(start_with([](v4l2_pix_format&) {}), Status::bad_argument);
  EXPECT_TRUE(says("buffers"));
  device->formats = {V4L2_PIX_FMT_MJPEG};
  EXPECT_EQ(camera->start(), Status::bad_argument);
  EXPECT_TRUE(says("no 8-bit format"));
}

TEST_F(DeviceSettings, FixesExposureGainAndPeriodWhereTheDeviceCan) {
  make({.period = 33333us, .exposure = 4000us, .gain = 20});
  EXPECT_EQ(camera->start(), Status::bad_argument);
  EXPECT_TRUE(says("cannot fix its exposure"));
  device->settings[V4L2_CID_EXPOSURE_AUTO] = {0, 3, V4L2_EXPOSURE_APERTURE_PRIORITY};
  device->settings[V4L2_CID_EXPOSURE_ABSOLUTE] = {1, 30, 0};
  EXPECT_EQ(camera->start(), Status::bad_argument);  // 4 ms are 40 units
  EXPECT_TRUE(says("1 to 30"));
  device->settings[V4L2_CID_EXPOSURE_ABSOLUTE].max = 5000;
  EXPECT_EQ(camera->start(), Status::bad_argument);
  EXPECT_TRUE(says("cannot fix its gain"));
  device->settings[V4L2_CID_GAIN] = {0, 100, 0};
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  EXPECT_EQ(device->settings[V4L2_CID_EXPOSURE_AUTO].value, V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(device->settings[V4L2_CID_EXPOSURE_ABSOLUTE].value, 40);
  EXPECT_EQ(device->settings[V4L2_CID_GAIN].value, 20);
  EXPECT_EQ(camera->warning(), "the camera keeps its own frame duration");
  device->period_can_be_set = true;
  ASSERT_EQ(camera->start(), Status::ok);
  EXPECT_EQ(device->period.numerator, 33333u);
  EXPECT_EQ(camera->warning(), "");
}

TEST_F(DeviceSettings, WarnsOfTheFrameDurationThatItGetsWhereItIsNotTheOneAskedFor) {
  make({.period = 33333us});
  device->period_can_be_set = true;
  device->nearest_period = v4l2_fract{1, 25};
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  EXPECT_EQ(camera->warning(), "the camera keeps its own frame duration, 40000 us, instead of 33333 us");
  device->nearest_period = v4l2_fract{1001, 30000};  // 29.97 frames a second are what is meant by 30
  ASSERT_EQ(camera->start(), Status::ok);
  EXPECT_EQ(camera->warning(), "");
}

TEST_F(DeviceSettings, LetsTheRateGoBeforeAutomaticExposureOnlyWhereARateWasAskedFor) {
  for (const auto period : {0us, 33333us}) {
    make({.period = period});
    device->settings[V4L2_CID_EXPOSURE_AUTO_PRIORITY] = {0, 1, 1};
    ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
    EXPECT_EQ(device->settings[V4L2_CID_EXPOSURE_AUTO_PRIORITY].value, period == 0us ? 1 : 0);
  }
}

TEST_F(DeviceSettings, TakesTheBestFormatThatTheDeviceGivesAtTheSizeAskedFor) {
  EXPECT_EQ(start_with([](v4l2_pix_format& f) { f.width += f.pixelformat == V4L2_PIX_FMT_GREY ? 16 : 0; }), Status::ok);
  EXPECT_EQ(device->format, V4L2_PIX_FMT_YUYV);
  EXPECT_NE(camera->description().find("luma copied"), std::string::npos) << camera->description();
}

}  // namespace
}  // namespace articam
