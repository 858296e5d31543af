#include "host_sim/ports/sim_camera.hpp"

#include <utility>

namespace articam::sim {

SimCamera::SimCamera(Renderer& renderer, Scene scene, SimClock& clock, const Options& options)
    : SimCamera{[&renderer, scene = std::move(scene), pixels = std::vector<std::uint8_t>{}](
                    double t_s, std::uint32_t k) mutable -> ImageView {
                  renderer.render(scene(t_s), k, pixels);
                  const CameraParameters& camera = renderer.camera();
                  return {pixels.data(), camera.width_px, camera.height_px, camera.width_px};
                },
                clock, options} {}

SimCamera::SimCamera(Expose expose, SimClock& clock, Options options)
    : expose_{std::move(expose)}, clock_{clock}, options_{std::move(options)} {}

Status SimCamera::start() noexcept {
  return is_unplugged(seconds_between({}, clock_.now())) ? Status::no_device : Status::ok;
}

Status SimCamera::acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept {
  constexpr std::int64_t kNsPerMs = 1'000'000;
  const Timestamp patience{clock_.now().ns + wait.count() * kNsPerMs};
  const bool again = std::exchange(repeat_, false);
  if (again) --next_;
  while (next_ < options_.num_frames && (fate().lost || is_unplugged(seconds_between({}, t_exposure(next_))))) ++next_;
  if (next_ >= options_.num_frames) return Status::end_of_stream;
  const Timestamp t = t_exposure(next_);
  const Timestamp arrival{t.ns + (options_.latency + fate().delay).count() * kNsPerMs};
  if (arrival > patience) {
    clock_.advance_to(patience);
    return is_unplugged(seconds_between({}, patience)) ? Status::no_device : Status::timeout;
  }
  clock_.advance_to(arrival);
  out = {expose_(seconds_between({}, t), next_), {t.ns + fate().stamp_error.count() * kNsPerMs}, next_};
  repeat_ = fate().repeated && !again;
  ++next_;
  return Status::ok;
}

void SimCamera::release(hal::Frame& frame) noexcept { frame.pixels = {}; }

Timestamp SimCamera::t_exposure(std::uint32_t sequence) const noexcept {
  return from_seconds(sequence / options_.rate_hz);
}

}  // namespace articam::sim
