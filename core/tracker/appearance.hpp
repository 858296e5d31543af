#pragma once
/// @file  A configuration -> the shape of every marker on the metric plane, and which of them a frame has to show.

#include "core/tracker/features.hpp"
#include "core/tracker/sighting.hpp"

namespace articam::tracker {

/// A marker as a configuration shows it.
template <class S>
struct Appearance {
  bool visible{};                       ///< it faces the camera, its centre inside the image
  bool expected{};                      ///< a frame without it needs an excuse
  Vec<S, 3> centre{Vec<S, 3>::Zero()};  ///< m, {cam}
  Vec<S, 2> s{Vec<S, 2>::Zero()};       ///< centre of its image, metric plane
  S radius{};                           ///< of its image, metric plane
  Shape<S> shape{Shape<S>::Zero()};
};

template <class M, class S>
using Appearances = std::array<Appearance<S>, static_cast<std::size_t>(model::kNumMarkers<M>)>;

/// The imaged ellipse's second moments: with the dual conic C* of imaged_circle.hpp and its centre s,
/// s s^T - C*(xy, xy) / C*(zz).
template <class S>
Shape<S> imaged_shape(const vision::Circle<S>& circle, const Vec<S, 2>& s) noexcept {
  const auto& [c, n, r] = circle;
  const S r2 = r * r, m_z = c.z() * c.z() + r2 * (n.z() * n.z() - S(1));
  return {s.x() * s.x() - (c.x() * c.x() + r2 * (n.x() * n.x() - S(1))) / m_z,
          s.x() * s.y() - (c.x() * c.y() + r2 * n.x() * n.y()) / m_z,
          s.y() * s.y() - (c.y() * c.y() + r2 * (n.y() * n.y() - S(1))) / m_z};
}

/// Whether a mark of that image is large and upright enough to be found surely, and wholly inside the image. A ring
/// needs room for its hole; of dots whose short half-axis is 2.5 px the detector finds 95 of 100 in clutter.
template <class S>
bool is_conspicuous(model::MarkerKind kind, const Appearance<S>& marker, S facing, const Vec<S, 2>& pixel,
                    const vision::CameraModel<S>& camera) noexcept {
  constexpr S kMinRingRadius_px{5}, kMinDotHalfAxis_px{S(2.5)}, kMinFacing{S(0.3)};  // 73 degrees
  const S radius_px = marker.radius * camera.focal_px(), margin = radius_px + S(2);
  const bool large =
      kind == model::MarkerKind::ring ? radius_px >= kMinRingRadius_px : radius_px * facing >= kMinDotHalfAxis_px;
  const auto& size = camera.parameters();
  return large && facing >= kMinFacing && pixel.x() > margin && pixel.y() > margin &&
         pixel.x() < static_cast<S>(size.width_px) - margin && pixel.y() < static_cast<S>(size.height_px) - margin;
}

/// A marker behind another one has an excuse.
template <class M, class S>
void excuse_hidden(Appearances<M, S>& markers) noexcept {
  for (std::size_t far = 0; far < markers.size(); ++far) {
    if (!markers[far].expected) continue;
    const S diameter_m = static_cast<S>(M::kMarkers[far].outer_diameter_m);
    for (const Appearance<S>& near : markers) {
      if (!near.visible || !(near.centre.z() + S(0.5) * diameter_m < markers[far].centre.z())) continue;
      const S reach = S(1.5) * (near.radius + markers[far].radius);  // a card around the mark hides, too
      if ((near.s - markers[far].s).squaredNorm() < reach * reach) markers[far].expected = false;
    }
  }
}

template <class M, class S>
Appearances<M, S> appear(const model::Configuration<M, S>& q, const vision::CameraModel<S>& camera) noexcept {
  Appearances<M, S> markers{};
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const model::MarkerRow& row = M::kMarkers[i];
    if (row.kind == model::MarkerKind::point) continue;
    const auto circle = circle_in_camera(q.T_cam_obj, kinematics.markers[i], row.outer_diameter_m);
    const S facing = -circle.normal.dot(circle.centre);
    Appearance<S>& marker = markers[i];
    marker.centre = circle.centre;
    const auto s = vision::imaged_centre(circle);
    if (!s.ok() || !(facing > S(0)) || !camera.in_domain(s.value())) continue;
    const Vec<S, 2> pixel = camera.project(s.value());
    const auto& size = camera.parameters();
    marker.visible = pixel.x() >= S(0) && pixel.x() < static_cast<S>(size.width_px) && pixel.y() >= S(0) &&
                     pixel.y() < static_cast<S>(size.height_px);
    marker.s = s.value();
    marker.radius = circle.radius / circle.centre.z();
    marker.shape = imaged_shape(circle, s.value());
    marker.expected = marker.visible && is_conspicuous(row.kind, marker, facing / circle.centre.norm(), pixel, camera);
  }
  excuse_hidden<M, S>(markers);
  return markers;
}

}  // namespace articam::tracker
