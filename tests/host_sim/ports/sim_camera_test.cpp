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

/// Three frames of which the fate is given.
struct Fated {
  SimClock clock;
  SimCamera camera;

  explicit Fated(std::function<FrameFate(std::uint32_t)> fate, std::function<bool(double)> unplugged = {})
      : camera{[](double, std::uint32_t) { return ImageView{}; },
               clock,
               {.rate_hz = 10, .num_frames = 3, .fate = std::move(fate), .unplugged = std::move(unplugged)}} {}

  hal::Frame next() {
    hal::Frame frame;
    EXPECT_EQ(camera.acquire(frame, milliseconds{1000}), Status::ok);
    return frame;
  }
};

TEST(SimCamera, LeavesAGapWhereAFrameIsLost) {
  Fated world{[](std::uint32_t k) { return FrameFate{.lost = k == 1}; }};
  EXPECT_EQ(world.next().sequence, 0u);
  EXPECT_EQ(world.next().sequence, 2u);
}

TEST(SimCamera, BringsARepeatedFrameTwiceAtOneTime) {
  Fated world{[](std::uint32_t k) { return FrameFate{.repeated = k == 1}; }};
  world.next();
  const hal::Frame first = world.next();
  const Timestamp then = world.clock.now();
  const hal::Frame again = world.next();
  EXPECT_EQ(again.sequence, first.sequence);
  EXPECT_EQ(again.t_exposure, first.t_exposure);
  EXPECT_EQ(world.clock.now(), then);
  EXPECT_EQ(world.next().sequence, 2u);
}

TEST(SimCamera, BringsALateFrameLateAndTheNextBehindIt) {
  Fated world{[](std::uint32_t k) { return FrameFate{.delay = milliseconds{k == 0 ? 200 : 0}}; }};
  world.next();
  EXPECT_EQ(world.clock.now().ns, 215'000'000);
  EXPECT_EQ(world.next().t_exposure, from_seconds(0.1)) << "it has waited";
  EXPECT_EQ(world.clock.now().ns, 215'000'000);
}

TEST(SimCamera, SaysThatItIsGoneAndComesBack) {
  Fated world{{}, [](double t_s) { return t_s > 0.05 && t_s < 0.15; }};
  world.next();
  hal::Frame frame;
  EXPECT_EQ(world.camera.acquire(frame, milliseconds{80}), Status::no_device);
  EXPECT_EQ(world.next().sequence, 2u);
}

}  // namespace
}  // namespace articam::sim
