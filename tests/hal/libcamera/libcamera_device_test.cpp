/// @file  The real library, where no camera is: all that can be held here without one.

#include "hal/libcamera/libcamera_camera.hpp"

#include <gtest/gtest.h>
#include <libcamera/control_ids.h>
#include <libcamera/controls.h>

#include "hal/libcamera/library_version.hpp"

namespace articam {
namespace {

namespace ids = libcamera::controls;

/// What a sensor on CSI says that it can do.
const libcamera::ControlInfoMap& known() {
  static const libcamera::ControlInfoMap map{
      {{&ids::ExposureTime, libcamera::ControlInfo{std::int32_t{100}, std::int32_t{30'000}}},
       {&ids::AnalogueGain, libcamera::ControlInfo{1.0f, 8.0f}},
       {&ids::AeEnable, libcamera::ControlInfo{false, true}},
       {&ids::FrameDurationLimits, libcamera::ControlInfo{std::int64_t{8000}, std::int64_t{1'000'000}}}},
      ids::controls};
  return map;
}

TEST(LibcameraControls, OfARequestCarryExposureGainAndFrameDuration) {
  const auto list = hal::control_list(known(), {.exposure_us = 4000, .gain = 2.0f, .period_us = 33'333});
  EXPECT_EQ(list.get(ids::ExposureTime), 4000);
  EXPECT_EQ(list.get(ids::AnalogueGain), 2.0f);
  const auto limits = list.get(ids::FrameDurationLimits);
  ASSERT_TRUE(limits);
  EXPECT_EQ((*limits)[0], 33'333);
  EXPECT_EQ((*limits)[1], 33'333);
  libcamera::ControlList request{ids::controls};
  request.merge(list);  // as a request takes them up
  EXPECT_EQ(request.size(), list.size());
}

TEST(LibcameraControls, OfARequestLeaveAutomaticWhatIsNotFixed) {
  const auto list = hal::control_list(known(), {});
  EXPECT_FALSE(list.contains(ids::ExposureTime.id()));
  EXPECT_FALSE(list.contains(ids::AnalogueGain.id()));
  EXPECT_FALSE(list.contains(ids::FrameDurationLimits.id()));
  if (list.contains(ids::AeEnable.id())) {
    EXPECT_EQ(list.get(ids::AeEnable), true);
  }
}

TEST(LibcameraDevice, SaysThatThereIsNoCameraAsOftenAsItIsAsked) {
  hal::LibcameraCamera camera{{.width_px = 640, .height_px = 480}};
  for (int i = 0; i < 3; ++i) {
    const Status status = camera.start();
    if (status == Status::ok) GTEST_SKIP() << "this machine has a camera: " << camera.description();
    ASSERT_EQ(status, Status::no_device) << camera.problem();
    EXPECT_NE(camera.problem().find("finds no camera"), std::string_view::npos);
    camera.stop();
  }
}

}  // namespace
}  // namespace articam
