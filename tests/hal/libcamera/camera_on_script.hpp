#pragma once
/// @file  A camera of libcamera on a scripted device.

#include <gtest/gtest.h>

#include <memory>
#include <string_view>

#include "hal/libcamera/libcamera_camera.hpp"
#include "tests/hal/libcamera/scripted_device.hpp"

namespace articam::test {

inline constexpr int kWidth_px = 16, kHeight_px = 8;

class CameraOnScript : public testing::Test {
 protected:
  void make(hal::LibcameraOptions options = {}) {
    if (options.width_px == 0) options.width_px = kWidth_px;
    options.height_px = kHeight_px;
    options.first_frame_wait = std::chrono::milliseconds{20};
    auto owned = std::make_unique<ScriptedDevice>();
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
    ASSERT_TRUE(device->complete(1, bend));
    frame = {};
    EXPECT_EQ(camera->acquire(frame, std::chrono::milliseconds{0}), Status::timeout);
    EXPECT_EQ(frame.pixels.data, nullptr);
    EXPECT_TRUE(device->has_free(4));
  }

  ScriptedDevice* device{};
  std::unique_ptr<hal::LibcameraCamera> camera;
  hal::Frame frame;
};

}  // namespace articam::test
