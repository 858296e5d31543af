#pragma once
/// @file  What the camera should see of a configuration.

#include <array>
#include <cstdint>

#include "core/model/configuration.hpp"
#include "core/model/forward_kinematics.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"
#include "core/vision/imaged_circle.hpp"
#include "core/vision/imaged_ellipse.hpp"
#include "core/vision/lens_ellipse.hpp"

namespace articam::tracker {

/// What a marker's image is taken for.
enum class FeatureKind : std::uint8_t {
  point,          ///< the projection of its centre, as in the paper
  imaged_circle,  ///< the centre of its imaged ellipse
};

/// A marker as the predicted configuration shows it.
template <class S>
struct Feature {
  bool visible{};  ///< in front of the camera, facing it, its centre inside the image
  vision::MarkKind kind{};
  vision::Ellipse image{};             ///< of its outer edge, as a detector would report it
  Vec<S, 2> pixel{Vec<S, 2>::Zero()};  ///< centre of that, or the image of the marker's centre (FeatureKind)
  S radius_px{};                       ///< semi-major axis of `image`
  // How badly the configuration is known, see spread_features(); 0 where it is known.
  Mat<S, 2, 2> covariance{Mat<S, 2, 2>::Zero()};  ///< of `pixel`, px^2
  S size_variance{};                              ///< of the logarithm of the image's area
  Vec<S, 2> rate{Vec<S, 2>::Zero()};              ///< of `pixel` on the metric plane, 1/s, see set_rates()
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

/// A circle's image through the lens. Errors  of imaged_ellipse() and distorted_ellipse().
template <class S>
Result<vision::PlaneEllipse<S>> image_of(const vision::Circle<S>& circle,
                                         const vision::CameraModel<S>& camera) noexcept {
  const auto on_plane = vision::imaged_ellipse(circle);
  if (!on_plane.ok()) return on_plane.status();
  return vision::distorted_ellipse(on_plane.value(), camera);
}

/// q -> every marker's image. Points without a mark are never visible.
template <class M, class S>
Features<M, S> predict_features(const model::Configuration<M, S>& q, const vision::CameraModel<S>& camera,
                                FeatureKind kind = FeatureKind::imaged_circle) noexcept {
  Features<M, S> features{};
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const model::MarkerRow& row = M::kMarkers[i];
    const auto circle = circle_in_camera(q.T_cam_obj, kinematics.markers[i], row.outer_diameter_m);
    if (row.kind == model::MarkerKind::point || !(circle.normal.dot(circle.centre) < S(0))) continue;
    const auto image = image_of(circle, camera);
    if (!image.ok()) continue;
    Feature<S>& feature = features[i];
    feature.kind = mark_kind(row.kind);
    feature.image = vision::to_q16(image.value());
    feature.pixel = kind == FeatureKind::point ? camera.project(circle.centre.template head<2>() / circle.centre.z())
                                               : image.value().centre;
    feature.radius_px = vision::semi_major(image.value());
    const auto& size = camera.parameters();
    feature.visible = feature.pixel.x() >= S(0) && feature.pixel.x() < static_cast<S>(size.width_px) &&
                      feature.pixel.y() >= S(0) && feature.pixel.y() < static_cast<S>(size.height_px);
  }
  return features;
}

}  // namespace articam::tracker
