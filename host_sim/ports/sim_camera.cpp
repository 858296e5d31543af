#include "host_sim/ports/sim_camera.hpp"

#include <utility>

namespace articam::sim {

SimCamera::SimCamera(Renderer& renderer, Scene scene, SimClock& clock, const Options& options)
    : renderer_{renderer}, scene_{std::move(scene)}, clock_{clock}, options_{options} {}

Status SimCamera::start() noexcept {
  next_ = 0;
  return Status::ok;
}

Status SimCamera::acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept {
  constexpr std::int64_t kNsPerMs = 1'000'000;
  if (next_ >= options_.num_frames) return Status::end_of_stream;
  const Timestamp t = t_exposure(next_);
  const Timestamp arrival{t.ns + options_.latency.count() * kNsPerMs};
  const Timestamp patience{clock_.now().ns + wait.count() * kNsPerMs};
  if (arrival > patience) {
    clock_.advance_to(patience);
    return Status::timeout;
  }
  clock_.advance_to(arrival);
  renderer_.render(scene_(seconds_between({}, t)), next_, pixels_);
  const CameraParameters& camera = renderer_.camera();
  out = {{pixels_.data(), camera.width_px, camera.height_px, camera.width_px}, t, next_};
  ++next_;
  return Status::ok;
}

void SimCamera::release(hal::Frame& frame) noexcept { frame.pixels = {}; }

Timestamp SimCamera::t_exposure(std::uint32_t sequence) const noexcept {
  return from_seconds(sequence / options_.rate_hz);
}

}  // namespace articam::sim
