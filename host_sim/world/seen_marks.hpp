#pragma once
/// @file  Detections without an image: where the marks' edges truly are, with a detector's noise.

#include "core/tracker/features.hpp"
#include "core/vision/detection.hpp"
#include "host_sim/world/hash.hpp"

namespace articam::sim {

/// What the detector measured of its own noise, and says of it, in rendered frames of noise 1 to 10 grey levels, blur
/// 0.7 px and rings of 9 to 40 px radius: a standard deviation of the centre of
///     sqrt(0.0025^2 + (0.0064 noise)^2 / radius) px;
/// of the axes three halves of that variance, and a bias of up to 0.25 px^2 / radius that it only owns to.
struct EdgeNoise {
  double centre_px2, axis_px2;  ///< variances that it has
  double owned_axis_px2;        ///< that it reports
};
EdgeNoise edge_noise(double radius_px, double noise_grey) noexcept;

/// About normal: the sum of twelve. Ends at 6 sigma.
double normal(Dice& dice) noexcept;

/// The ellipse of a true edge as a detector would measure it.
vision::Ellipse measured(const vision::PlaneEllipse<double>& edge, const EdgeNoise& noise, Dice& dice) noexcept;

std::uint32_t variance_q24(double variance_px2) noexcept;

/// All marks wholly in the image, in the table's order; of the first `most` markers.
template <class Model>
void see_marks(const model::Configuration<Model, double>& q, const vision::CameraModel<double>& camera,
               double noise_grey, int most, Dice& dice, vision::Detections& out) noexcept {
  out.clear();
  const auto kinematics = model::forward_kinematics<Model, double>(q.joints);
  const auto& size = camera.parameters();
  for (std::size_t i = 0; i < Model::kMarkers.size() && static_cast<int>(i) < most; ++i) {
    const model::MarkerRow& row = Model::kMarkers[i];
    if (row.kind == model::MarkerKind::point) continue;
    const auto circle = tracker::circle_in_camera(q.T_cam_obj, kinematics.markers[i], row.outer_diameter_m);
    if (!(circle.normal.dot(circle.centre) < 0)) continue;
    const auto outer = tracker::image_of(circle, camera);
    if (!outer.ok()) continue;
    const double radius_px = vision::semi_major(outer.value());
    const Vec<double, 2> c = outer.value().centre;
    if (!(c.x() > radius_px && c.y() > radius_px && c.x() < size.width_px - 1 - radius_px &&
          c.y() < size.height_px - 1 - radius_px))
      continue;
    vision::Detection mark;
    mark.kind = tracker::mark_kind(row.kind);
    const EdgeNoise noise = edge_noise(radius_px, noise_grey);
    mark.outer = measured(outer.value(), noise, dice);
    mark.centre_variance_q24 = variance_q24(noise.centre_px2);
    mark.axis_variance_q24 = variance_q24(noise.owned_axis_px2);
    if (row.kind == model::MarkerKind::ring) {
      auto hole = circle;
      hole.radius = 0.5 * row.inner_diameter_m;
      const auto inner = tracker::image_of(hole, camera);
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
