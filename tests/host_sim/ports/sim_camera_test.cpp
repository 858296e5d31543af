#include "host_sim/ports/sim_camera.hpp"

#include <gtest/gtest.h>

namespace articam::sim {
namespace {

using std::chrono::milliseconds;

CameraParameters small_camera() {
  CameraParameters camera;
  camera.width_px = 32, camera.height_px = 24;
  camera.fx_px = camera.fy_px = 30;
  return camera;
}

struct World {
  Renderer renderer{small_camera(), {}};
  SimClock clock;
  std::vector<double> looked_at_s;
  SimCamera camera{renderer,
                   [this](double t_s) {
                     looked_at_s.push_back(t_s);
                     return std::vector<SceneMarker>{};
                   },
                   clock,
                   {.rate_hz = 30, .num_frames = 3, .latency = milliseconds{15}}};
};

TEST(SimCamera, StampsMidExposureCountsAndEnds) {
  World world;
  ASSERT_EQ(world.camera.start(), Status::ok);
  for (std::uint32_t i = 0; i < 3; ++i) {
    hal::Frame frame;
    ASSERT_EQ(world.camera.acquire(frame, milliseconds{50}), Status::ok);
    EXPECT_EQ(frame.sequence, i);
    EXPECT_EQ(frame.t_exposure, from_seconds(i / 30.0));
    EXPECT_TRUE(frame.pixels.ok());
    EXPECT_EQ(world.clock.now().ns, frame.t_exposure.ns + 15'000'000) << "a frame arrives after its exposure";
    EXPECT_EQ(world.looked_at_s.back(), seconds_between({}, frame.t_exposure));
    world.camera.release(frame);
  }
  hal::Frame frame;
  EXPECT_EQ(world.camera.acquire(frame, milliseconds{50}), Status::end_of_stream);
}

TEST(SimCamera, LosesNoFrameToAnImpatientCaller) {
  World world;
  ASSERT_EQ(world.camera.start(), Status::ok);
  hal::Frame frame;
  EXPECT_EQ(world.camera.acquire(frame, milliseconds{10}), Status::timeout);
  EXPECT_EQ(world.clock.now().ns, 10'000'000) << "waiting takes its time";
  EXPECT_EQ(world.camera.acquire(frame, milliseconds{10}), Status::ok);
  EXPECT_EQ(frame.sequence, 0u);
}

}  // namespace
}  // namespace articam::sim
