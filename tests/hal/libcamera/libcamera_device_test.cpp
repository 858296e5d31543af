/// @file  The real library, where no camera is: all that can be held here without one.

#include "hal/libcamera/libcamera_camera.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

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
