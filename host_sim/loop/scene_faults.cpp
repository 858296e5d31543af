#include "host_sim/loop/scene_faults.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/world/hash.hpp"

namespace articam::sim {

double fault_at(std::span<const Fault> faults, FaultKind kind, double t_s, double otherwise) noexcept {
  const auto found = std::ranges::find_if(faults, [&](const Fault& f) { return f.kind == kind && f.at(t_s); });
  return found == faults.end() ? otherwise : found->amount;
}

FrameFate fate_of(std::span<const Fault> faults, double t_s, std::uint32_t k, std::uint64_t seed) noexcept {
  FrameFate fate;
  const double lost_share =
      fault_at(faults, FaultKind::silent, t_s, -1) >= 0 ? 1 : fault_at(faults, FaultKind::dropped, t_s, 0);
  fate.lost = Dice{seed ^ hash(k)}.between(0, 1) < lost_share;
  fate.repeated = fault_at(faults, FaultKind::repeated, t_s, 0) > 0;
  const double late_s = fault_at(faults, FaultKind::late, t_s, 0);
  fate.delay = std::chrono::milliseconds{static_cast<int>(1000 * late_s)};
  fate.stamp_error = std::chrono::milliseconds{static_cast<int>(1000 * fault_at(faults, FaultKind::stamped, t_s, 0))};
  return fate;
}

void apply(std::span<const Fault> faults, double t_s, std::vector<SceneMarker>& markers) {
  const auto seen =
      static_cast<std::size_t>(fault_at(faults, FaultKind::hidden, t_s, static_cast<double>(markers.size())));
  if (seen < markers.size()) markers.resize(seen);
  const double moved_m = fault_at(faults, FaultKind::moved, t_s, 0);
  if (moved_m != 0 && !markers.empty()) {
    markers.front().centre_cam_m += moved_m * markers.front().normal_cam.unitOrthogonal();
  }
  const double warped_m = fault_at(faults, FaultKind::warped, t_s, 0);
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const Vec<double, 3> aside = markers[i].normal_cam.unitOrthogonal();
    // A fourth of a turn from marker to marker.
    const Vec<double, 3> way = i % 2 == 0 ? aside : markers[i].normal_cam.cross(aside);
    markers[i].centre_cam_m += (i % 4 < 2 ? warped_m : -warped_m) * way;
  }
  const int planted = static_cast<int>(fault_at(faults, FaultKind::planted, t_s, 0));
  if (planted == 0 || markers.empty()) return;
  // Beside the first marker, its like, and slowly on.
  const SceneMarker like = markers.front();
  const Vec<double, 3> aside = like.normal_cam.unitOrthogonal(), down = like.normal_cam.cross(aside);
  for (int i = 0; i < planted; ++i) {
    SceneMarker other = like;
    const double way_m = 0.1 + 0.075 * i + 0.01 * std::fmod(t_s, 3.0);
    other.centre_cam_m += way_m * aside + 0.06 * (i % 2) * down;
    other.velocity += 0.01 * aside;
    markers.push_back(other);
  }
}

ImageView cut(std::span<const Fault> faults, double t_s, std::uint32_t k, ImageView frame) noexcept {
  if (!(fault_at(faults, FaultKind::cut, t_s, 0) > 0)) return frame;
  if (k % 2 == 0) {
    frame.height_px /= 2;
  } else {
    --frame.stride_bytes;
  }
  return frame;
}

RenderOptions rendering_at(std::span<const Fault> faults, double t_s, const RenderOptions& usual) noexcept {
  RenderOptions rendering = usual;
  rendering.exposure = fault_at(faults, FaultKind::exposure, t_s, usual.exposure);
  if (const double rate_hz = fault_at(faults, FaultKind::flicker, t_s, 0); rate_hz > 0) {
    const double phase = std::fmod(rate_hz * t_s, 1.0);
    rendering.exposure = 0.5 + 0.8 * (phase < 0.5 ? 2 * phase : 2 - 2 * phase);
  }
  rendering.blur_px = fault_at(faults, FaultKind::blur, t_s, usual.blur_px);
  return rendering;
}

}  // namespace articam::sim
