#pragma once
/// @file  A camera that looks at the synthetic world.

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "hal/ports/camera_port.hpp"
#include "host_sim/ports/sim_clock.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// Frame k shows the world at the instant k / rate (all rows at once) and arrives `latency` later; waiting for it moves
/// the clock there. One frame is lent at a time.
class SimCamera {
 public:
  using Scene = std::function<std::vector<SceneMarker>(double t_s)>;

  struct Options {
    double rate_hz = 30;
    std::uint32_t num_frames = 0;           ///< then end_of_stream
    std::chrono::milliseconds latency{15};  ///< from mid-exposure to arrival
  };

  SimCamera(Renderer& renderer, Scene scene, SimClock& clock, const Options& options);

  Status start() noexcept;
  void stop() noexcept {}
  Status acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept;
  void release(hal::Frame& frame) noexcept;

  /// Mid-exposure of a frame, to the nanosecond.
  Timestamp t_exposure(std::uint32_t sequence) const noexcept;

 private:
  Renderer& renderer_;
  Scene scene_;
  SimClock& clock_;
  Options options_;
  std::uint32_t next_{};
  std::vector<std::uint8_t> pixels_;
};
static_assert(hal::CameraPort<SimCamera>);

}  // namespace articam::sim
