/// @file  What every implementation of a port must do, whichever it is.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <thread>

#include "hal/libcamera/libcamera_camera.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/memory/memory_camera.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/replay/pgm_camera.hpp"
#include "hal/supervision/supervised_camera.hpp"
#include "hal/v4l2/v4l2_camera.hpp"
#include "host_sim/ports/sim_camera.hpp"

#include "tests/hal/libcamera/scripted_device.hpp"
#include "tests/hal/v4l2/scripted_video_device.hpp"
#include "tests/support/own_folder.hpp"

namespace articam {
namespace {

CameraParameters tiny_camera() {
  CameraParameters p;
  p.width_px = 16, p.height_px = 8, p.fx_px = p.fy_px = 20, p.cx_px = 7.5, p.cy_px = 3.5;
  return p;
}

/// Each stage makes a camera that gives kFrames frames of 16 x 8 pixels, and knows how to make the next one come.
constexpr std::uint32_t kFrames = 3;

struct SimStage {
  sim::SimClock clock;
  sim::Renderer renderer{tiny_camera(), {}};
  sim::SimCamera camera{
      renderer, [](double) { return std::vector<sim::SceneMarker>{}; }, clock, {.num_frames = kFrames}};
  void next(std::uint32_t) {}
  static constexpr bool kEnds = true;
};

struct PgmStage {
  PgmStage() {
    std::filesystem::create_directories(folder);
    const std::vector<std::uint8_t> grey(16 * 8, 100);
    std::string why;
    for (std::uint32_t i = 0; i < kFrames; ++i) {
      EXPECT_EQ(hal::write_pgm(folder / (std::to_string(i) + ".pgm"), {grey.data(), 16, 8, 16}, why), Status::ok);
    }
    camera = std::make_unique<hal::PgmCamera>(hal::find_frames(folder.string()), 30);
  }
  ~PgmStage() { std::filesystem::remove_all(folder); }
  std::filesystem::path folder = test::own_folder();
  std::unique_ptr<hal::PgmCamera> camera;
  void next(std::uint32_t) {}
  static constexpr bool kEnds = true;
};

struct MemoryStage {
  hal::MemoryCamera camera;
  std::vector<std::uint8_t> grey = std::vector<std::uint8_t>(16 * 8, 100);
  void next(std::uint32_t i) { camera.hand_over({{grey.data(), 16, 8, 16}, from_seconds(0.1 + i), i}); }
  static constexpr bool kEnds = false;
};

struct LibcameraStage {
  std::unique_ptr<test::ScriptedDevice> owned = std::make_unique<test::ScriptedDevice>();
  test::ScriptedDevice& device = *owned;
  hal::LibcameraCamera camera{{.width_px = 16, .height_px = 8}, std::move(owned)};
  void next(std::uint32_t i) { EXPECT_TRUE(device.complete(i + 1)); }  // frame 0 came at the start
  static constexpr bool kEnds = false;
};

struct V4l2Stage {
  std::unique_ptr<test::ScriptedVideoDevice> owned = std::make_unique<test::ScriptedVideoDevice>();
  test::ScriptedVideoDevice& device = *owned;
  hal::V4l2Camera camera{{.width_px = 16, .height_px = 8}, std::move(owned)};
  void next(std::uint32_t i) {
    std::this_thread::sleep_for(std::chrono::microseconds{2});  // the kernel's stamps count microseconds
    EXPECT_TRUE(device.complete(i + 1));
  }
  static constexpr bool kEnds = false;
};

struct SupervisedStage : MemoryStage {
  hal::ManualClock clock;
  hal::SupervisedCamera<hal::MemoryCamera, hal::ManualClock> camera{
      MemoryStage::camera, clock, {.period = std::chrono::milliseconds{33}}};
};

auto& camera_of(auto& stage) {
  if constexpr (requires { *stage.camera; })
    return *stage.camera;
  else
    return stage.camera;
}

template <class Stage>
class CameraContract : public testing::Test {};
using Stages = testing::Types<SimStage, PgmStage, MemoryStage, LibcameraStage, V4l2Stage, SupervisedStage>;
TYPED_TEST_SUITE(CameraContract, Stages);

TYPED_TEST(CameraContract, LendsReadableFramesWithRisingNumbersAndStampsAndLeavesTheFrameAloneWithoutOne) {
  using namespace std::chrono_literals;
  TypeParam stage;
  auto& camera = camera_of(stage);
  ASSERT_EQ(camera.start(), Status::ok);
  hal::Frame last;
  for (std::uint32_t i = 0; i < kFrames; ++i) {
    stage.next(i);
    hal::Frame frame;
    ASSERT_EQ(camera.acquire(frame, 1000ms), Status::ok);
    ASSERT_TRUE(frame.pixels.ok());
    EXPECT_EQ(frame.pixels.width_px, 16);
    EXPECT_EQ(frame.pixels.height_px, 8);
    unsigned sum = 0;
    for (int v = 0; v < 8; ++v) {
      for (int u = 0; u < 16; ++u) sum += frame.pixels.row(v)[u];
    }
    EXPECT_GT(sum, 0u);
    if (i > 0) {
      EXPECT_GT(frame.sequence, last.sequence);
      EXPECT_GT(frame.t_exposure, last.t_exposure);
    }
    last = frame;
    camera.release(frame);
  }
  hal::Frame untouched;
  untouched.sequence = 77;
  EXPECT_EQ(camera.acquire(untouched, 0ms), TypeParam::kEnds ? Status::end_of_stream : Status::timeout);
  EXPECT_EQ(untouched.sequence, 77u);
  EXPECT_EQ(untouched.pixels.data, nullptr);
}

TYPED_TEST(CameraContract, MayBeStoppedInAnyStateAndStartedAgain) {
  TypeParam stage;
  auto& camera = camera_of(stage);
  camera.stop();
  for (int round = 0; round < 3; ++round) {
    ASSERT_EQ(camera.start(), Status::ok);
    camera.stop();
    camera.stop();
  }
}

template <class Clock>
class ClockContract : public testing::Test {};
using Clocks = testing::Types<hal::ManualClock, hal::MonotonicClock, sim::SimClock>;
TYPED_TEST_SUITE(ClockContract, Clocks);

TYPED_TEST(ClockContract, NeverGoesBack) {
  TypeParam clock;
  const auto wind = [&](double t_s) {
    if constexpr (requires { clock.set(Timestamp{}); }) clock.set(from_seconds(t_s));
    if constexpr (requires { clock.advance_to(Timestamp{}); }) clock.advance_to(from_seconds(t_s));
  };
  Timestamp last = clock.now();
  for (const double t_s : {1.0, 2.0, 1.5, 0.0, 3.0}) {
    wind(t_s);
    EXPECT_GE(clock.now(), last);
    last = clock.now();
  }
}

}  // namespace
}  // namespace articam
