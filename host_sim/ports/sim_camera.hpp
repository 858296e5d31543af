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

/// What becomes of a frame on its way.
struct FrameFate {
  bool lost{};                               ///< never arrives; the next one's number tells
  bool repeated{};                           ///< comes a second time, at once
  std::chrono::milliseconds delay{0};        ///< on top of the usual latency; later frames wait behind it
  std::chrono::milliseconds stamp_error{0};  ///< its stamp is so much later than the truth
};

/// Frame k shows the world at the instant k / rate (its first row does; see Renderer) and arrives `latency` later;
/// waiting for it moves the clock there. One frame is lent at a time.
class SimCamera {
 public:
  using Scene = std::function<std::vector<SceneMarker>(double t_s)>;
  /// Frame k, taken at t_s: pixels that stay until the next.
  using Expose = std::function<ImageView(double t_s, std::uint32_t k)>;

  struct Options {
    double rate_hz = 30;
    std::uint32_t num_frames = 0;           ///< then end_of_stream
    std::chrono::milliseconds latency{15};  ///< from mid-exposure to arrival
    std::function<FrameFate(std::uint32_t k)> fate{};
    std::function<bool(double t_s)> unplugged{};  ///< then there are no frames, and it says no_device
  };

  SimCamera(Renderer& renderer, Scene scene, SimClock& clock, const Options& options);
  SimCamera(Expose expose, SimClock& clock, Options options);

  Status start() noexcept;
  void stop() noexcept {}
  Status acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept;
  void release(hal::Frame& frame) noexcept;

  /// Mid-exposure of a frame, to the nanosecond.
  Timestamp t_exposure(std::uint32_t sequence) const noexcept;

 private:
  FrameFate fate() const { return options_.fate ? options_.fate(next_) : FrameFate{}; }
  bool is_unplugged(double t_s) const { return options_.unplugged && options_.unplugged(t_s); }

  Expose expose_;
  SimClock& clock_;
  Options options_;
  std::uint32_t next_{};
  bool repeat_{false};  ///< the last frame comes again
};
static_assert(hal::CameraPort<SimCamera>);

}  // namespace articam::sim
