#include "host_sim/world/seen_marks.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/so3.hpp"
#include "core/tracker/features.hpp"
#include "core/tracker/rolling_shutter.hpp"

namespace articam::sim {
namespace {

constexpr double kMostHidden = 0.1;

/// An edge of a mark, when the row of the mark's centre is exposed.
Result<vision::PlaneEllipse<double>> edge(const SceneMarker& marker, double radius_m,
                                          const vision::CameraModel<double>& camera) noexcept {
  const Vec<double, 2> pixel = camera.project(marker.centre_cam_m.hnormalized());
  const double t_s = tracker::row_delay_s(camera.parameters(), pixel.y());
  return tracker::image_of<double>({marker.centre_cam_m + t_s * marker.velocity,
                                    math::exp_so3<double>(t_s * marker.angular_velocity) * marker.normal_cam, radius_m},
                                   camera);
}

bool is_wholly_inside(const vision::PlaneEllipse<double>& edge, const CameraParameters& camera) noexcept {
  const double radius_px = vision::semi_major(edge);
  const Vec<double, 2>& c = edge.centre;
  return c.x() > radius_px && c.y() > radius_px && c.x() < camera.width_px - 1 - radius_px &&
         c.y() < camera.height_px - 1 - radius_px;
}

}  // namespace

EdgeNoise edge_noise(double radius_px, double noise_grey) noexcept {
  constexpr double kGrid_px = 0.001, kPerGrey = 0.0064, kBias_px2 = 0.13;
  const double centre_px2 = kGrid_px * kGrid_px + kPerGrey * kPerGrey * noise_grey * noise_grey / radius_px;
  const double bias_px = kBias_px2 / radius_px;
  return {centre_px2, 1.5 * centre_px2, 1.5 * centre_px2 + bias_px * bias_px};
}

double normal(Dice& dice) noexcept {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += dice.between(0, 1);
  return sum;
}

vision::Ellipse measured(const vision::PlaneEllipse<double>& edge, const EdgeNoise& noise, Dice& dice) noexcept {
  const double centre_px = std::sqrt(noise.centre_px2), axis_px = std::sqrt(noise.axis_px2);
  vision::PlaneEllipse<double> seen = edge;
  for (double& x : seen.centre) x += centre_px * normal(dice);
  seen.M(0, 0) += axis_px * normal(dice);
  seen.M(1, 0) += axis_px * normal(dice);
  seen.M(1, 1) += axis_px * normal(dice);
  return vision::to_q16(seen);
}

std::uint32_t variance_q24(double variance_px2) noexcept {
  return static_cast<std::uint32_t>(std::clamp(variance_px2 * 16777216.0, 1.0, 4294967295.0));
}

void see_marks(std::span<const SceneMarker> markers, std::span<const Limb> limbs,
               const vision::CameraModel<double>& camera, double noise_grey, Dice& dice,
               vision::Detections& out) noexcept {
  out.clear();
  for (const SceneMarker& marker : markers) {
    if (marker.kind == model::MarkerKind::point || !(marker.centre_cam_m.z() > 0)) continue;
    if (!(marker.normal_cam.dot(marker.centre_cam_m) < 0)) continue;
    const auto outer = edge(marker, marker.outer_radius_m, camera);
    if (!outer.ok() || !is_wholly_inside(outer.value(), camera.parameters())) continue;
    if (hidden_share(limbs, marker.centre_cam_m, marker.normal_cam, marker.outer_radius_m) > kMostHidden) continue;
    vision::Detection mark;
    mark.kind = tracker::mark_kind(marker.kind);
    const EdgeNoise noise = edge_noise(vision::semi_major(outer.value()), noise_grey);
    mark.outer = measured(outer.value(), noise, dice);
    mark.centre_variance_q24 = variance_q24(noise.centre_px2);
    mark.axis_variance_q24 = variance_q24(noise.owned_axis_px2);
    if (marker.kind == model::MarkerKind::ring) {
      const auto inner = edge(marker, marker.inner_radius_m, camera);
      if (!inner.ok()) continue;
      const EdgeNoise at_hole = edge_noise(vision::semi_major(inner.value()), noise_grey);
      mark.inner = measured(inner.value(), at_hole, dice);
      mark.inner_centre_variance_q24 = variance_q24(at_hole.centre_px2);
      mark.inner_axis_variance_q24 = variance_q24(at_hole.owned_axis_px2);
    }
    if (!out.push_back(mark)) return;
  }
}

}  // namespace articam::sim
