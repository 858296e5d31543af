#pragma once
/// @file  Rows that are exposed one after the other: each mark is taken at its own row's time.
///
/// A frame's time is the first row's, and what moves has gone on by the time of row v:
///
///     s(v) = s + delay(v) ds/dt,    delay(v) = readout_time_s v / (height - 1)
///
/// to the first order. The rates are those that the frame itself implies, not those of the frame before alone: else a
/// wrong rate would shift the marks, and these the next rate, and the two would swing.

#include "core/model/point_jacobian.hpp"
#include "core/tracker/associate.hpp"

namespace articam::tracker {

inline bool is_rolling(const CameraParameters& camera) noexcept { return camera.readout_time_s > 0; }

/// v: a row, px. s after the first row.
template <class S>
S row_delay_s(const CameraParameters& camera, S v_px) noexcept {
  return static_cast<S>(camera.readout_time_s) * v_px / static_cast<S>(camera.height_px - 1);
}

/// Sets every visible feature's rate: ds/dt of an object that moves with qdot.
template <class M, class S>
void set_rates(const model::Configuration<M, S>& q, const Vec<S, model::kDof<M>>& qdot,
               Features<M, S>& features) noexcept {
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!features[i].visible) continue;
    const model::MarkerRow& row = M::kMarkers[i];
    const auto image =
        vision::moving_ellipse(circle_in_camera(q.T_cam_obj, kinematics.markers[i], row.outer_diameter_m));
    if (!image.ok()) continue;
    const Vec<S, 6> twist = model::point_jacobian<M, S>(kinematics, q.T_cam_obj, row.body).lazyProduct(qdot);
    features[i].rate = -image.value().L.template topRows<2>().lazyProduct(twist);  // L is of a camera that moves
  }
}

/// Features as they are in the first row's time -> where the camera will show them.
template <class M, class S>
void delay_features(const vision::CameraModel<S>& camera, Features<M, S>& features) noexcept {
  for (Feature<S>& feature : features) {
    if (!feature.visible) continue;
    const Vec<S, 2> moved = feature.rate * (row_delay_s(camera.parameters(), feature.pixel.y()) * camera.focal_px());
    feature.pixel += moved;
    feature.image.u_q16 += static_cast<std::int32_t>(moved.x() * S(65536));
    feature.image.v_q16 += static_cast<std::int32_t>(moved.y() * S(65536));
  }
}

/// Marks as the camera showed them -> where they were in the first row's time.
template <class M, class S>
Matches<M, S> without_delay(const vision::CameraModel<S>& camera, const Features<M, S>& features,
                            Matches<M, S> matches) noexcept {
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].matched) continue;
    const Vec<S, 2> moved = features[i].rate * row_delay_s(camera.parameters(), matches[i].pixel.y());
    matches[i].s_star -= moved;
    matches[i].pixel -= moved * camera.focal_px();
  }
  return matches;
}

}  // namespace articam::tracker
