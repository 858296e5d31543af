#pragma once
/// @file  What the camera should see of a configuration.

#include <array>

#include "core/model/configuration.hpp"
#include "core/model/forward_kinematics.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"
#include "core/vision/imaged_circle.hpp"

namespace articam::tracker {

/// A marker as the predicted configuration shows it.
template <class S>
struct Feature {
  bool visible{};  ///< in front of the camera, facing it, its centre inside the image
  vision::MarkKind kind{};
  Vec<S, 2> pixel{Vec<S, 2>::Zero()};  ///< centre of its image
  S radius_px{};                       ///< semi-major axis of its image
};

template <class M, class S>
using Features = std::array<Feature<S>, static_cast<std::size_t>(model::kNumMarkers<M>)>;

constexpr vision::MarkKind mark_kind(model::MarkerKind kind) noexcept {
  switch (kind) {
    case model::MarkerKind::dot_light_on_dark:
      return vision::MarkKind::dot_light_on_dark;
    case model::MarkerKind::dot_dark_on_light:
      return vision::MarkKind::dot_dark_on_light;
    default:
      return vision::MarkKind::ring;
  }
}

/// The marker of a table row as a circle in {cam}.
template <class S>
vision::Circle<S> circle_in_camera(const Pose<S>& T_cam_obj, const model::MarkerPlace<S>& place,
                                   double diameter_m) noexcept {
  return {T_cam_obj * place.centre, T_cam_obj.R * place.normal, static_cast<S>(0.5 * diameter_m)};
}

/// q -> every marker's image. Points without a mark are never visible.
template <class M, class S>
Features<M, S> predict_features(const model::Configuration<M, S>& q, const vision::CameraModel<S>& camera) noexcept {
  Features<M, S> features{};
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const model::MarkerRow& row = M::kMarkers[i];
    const auto circle = circle_in_camera(q.T_cam_obj, kinematics.markers[i], row.outer_diameter_m);
    const auto s = vision::imaged_centre(circle);
    if (!s.ok() || row.kind == model::MarkerKind::point) continue;
    Feature<S>& feature = features[i];
    feature.kind = mark_kind(row.kind);
    feature.pixel = camera.project(s.value());
    feature.radius_px = camera.focal_px() * circle.radius / circle.centre.z();
    const auto& size = camera.parameters();
    feature.visible = circle.normal.dot(circle.centre) < S(0) && feature.pixel.x() >= S(0) &&
                      feature.pixel.x() < static_cast<S>(size.width_px) && feature.pixel.y() >= S(0) &&
                      feature.pixel.y() < static_cast<S>(size.height_px);
  }
  return features;
}

}  // namespace articam::tracker
