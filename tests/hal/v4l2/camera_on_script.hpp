#pragma once
/// @file  A V4L2 camera on a scripted device.

#include <gtest/gtest.h>

#include <memory>
#include <string_view>

#include "hal/v4l2/v4l2_camera.hpp"
#include "tests/hal/v4l2/scripted_video_device.hpp"

namespace articam::test {

inline constexpr int kWidth_px = 16, kHeight_px = 8;
inline constexpr std::size_t kStride = kWidth_px + 16;

class VideoCameraOnScript : public testing::Test {
 protected:
  void make(hal::V4l2Options options = {}) {
    options.width_px = kWidth_px;
    options.height_px = kHeight_px;
    options.first_frame_wait = std::chrono::milliseconds{20};
    auto owned = std::make_unique<ScriptedVideoDevice>();
    device = owned.get();
    camera = std::make_unique<hal::V4l2Camera>(options, std::move(owned));
  }
  void SetUp() override { make(); }

  Status start_with(const std::function<void(v4l2_pix_format&)>& bend) {
    device->bend_format = bend;
    return camera->start();
  }
  bool says(std::string_view words) const { return camera->problem().find(words) != std::string_view::npos; }

  /// A bad buffer comes back: nobody sees it, and the device may write into it again.
  void expect_refused(const std::function<void(v4l2_buffer&)>& bend) {
    ASSERT_TRUE(device->complete(1, bend));
    frame = {};
    EXPECT_EQ(camera->acquire(frame, std::chrono::milliseconds{0}), Status::timeout);
    EXPECT_EQ(frame.pixels.data, nullptr);
    EXPECT_EQ(device->queued.size(), 4u);
  }

  ScriptedVideoDevice* device{};
  std::unique_ptr<hal::V4l2Camera> camera;
  hal::Frame frame;
};

}  // namespace articam::test
