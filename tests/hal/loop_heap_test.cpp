/// @file  The loop of the firmware never touches the heap.

#include <gtest/gtest.h>

#include <vector>

#include "hal/firmware.hpp"
#include "hal/memory/latest_link.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/memory/memory_camera.hpp"
#include "hal/run_loop.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "tests/support/heap_trap.hpp"

namespace articam {
namespace {

using Scenario = sim::PaperScenario;
using M = Scenario::Model;

/// 1,000 steps over a few rendered frames of the moving drawer, some of them empty: tracking, coasting, lost,
/// searching.
template <class S>
void expect_no_heap_call_in(tracker::Mode mode) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  using Tracker = tracker::Tracker<M, S>;
  sim::Renderer renderer{Scenario::camera(), {}};
  std::vector<std::vector<std::uint8_t>> images(24);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto markers = sim::scene_markers<M>(Scenario::at(Scenario::kRest_s + static_cast<double>(i) / 30).q);
    renderer.render(i < 20 ? std::span<const sim::SceneMarker>{markers} : std::span<const sim::SceneMarker>{}, i,
                    images[i]);
  }
  const auto& camera_file = Scenario::camera();
  Tracker tracker{camera_file, {.mode = mode, .feed_forward = mode == tracker::Mode::paper, .coast_time_s = 0.05}};
  hal::MemoryCamera camera;
  hal::ManualClock clock;
  hal::LatestLink<typename Tracker::EstimateType> link;
  hal::RunLoop loop{camera, clock, link, tracker, {.period = std::chrono::milliseconds{33}}};

  int seen[6]{};
  const test::HeapTrap trap;
  (void)loop.start();
  for (std::uint32_t k = 0; k < 1000; ++k) {
    const Timestamp t = from_seconds(k / 30.0);
    clock.set(t);
    const auto& image = images[k % images.size()];
    if (k % 50 != 49)
      camera.hand_over({{image.data(), camera_file.width_px, camera_file.height_px, camera_file.width_px}, t, k});
    (void)loop.run_once();
    ++seen[static_cast<int>(link.latest().status)];
  }
  EXPECT_EQ(trap.calls(), 0);
  EXPECT_GT(seen[static_cast<int>(tracker::TrackingStatus::tracking)], 500);
  EXPECT_GT(seen[static_cast<int>(tracker::TrackingStatus::coasting)], 0);
  EXPECT_GT(seen[static_cast<int>(tracker::TrackingStatus::lost)], 0);
}

TEST(LoopHeap, IsNotCalledByTheDefaultModeInDouble) { expect_no_heap_call_in<double>(tracker::Mode::standard); }
TEST(LoopHeap, IsNotCalledByTheDefaultModeInFloat) { expect_no_heap_call_in<float>(tracker::Mode::standard); }
TEST(LoopHeap, IsNotCalledByThePapersMode) { expect_no_heap_call_in<double>(tracker::Mode::paper); }

}  // namespace
}  // namespace articam
