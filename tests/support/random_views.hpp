#pragma once
/// @file  Random views of a model with all its markers in view, and what a detector would make of them.

#include <cmath>
#include <numbers>

#include "core/tracker/appearance.hpp"
#include "core/vision/plane_ellipse.hpp"
#include "tests/support/random_state.hpp"

namespace articam::test {

struct ViewLimits {
  double nearest_m{0.4}, farthest_m{1.5};  ///< depth of the middle of the markers
  double max_tilt_rad{std::numbers::pi / 3};
};

/// Whether the frame shows every ring or dot wholly, none hidden by another one's card (1.4 diameters) or by its edge.
template <class M>
bool shows_all(const model::Configuration<M, double>& q, const vision::CameraModel<double>& camera,
               double max_tilt_rad) {
  constexpr double kCard = 1.4;
  const auto markers = tracker::appear<M, double>(q, camera);
  const auto kinematics = model::forward_kinematics<M, double>(q.joints);
  const auto& size = camera.parameters();
  for (std::size_t i = 0; i < markers.size(); ++i) {
    if (M::kMarkers[i].kind == model::MarkerKind::point) continue;
    const Vec<double, 3> normal = q.T_cam_obj.R * kinematics.markers[i].normal;
    if (-normal.dot(markers[i].centre.normalized()) < std::cos(max_tilt_rad)) return false;
    const Vec<double, 2> pixel = camera.project(markers[i].s);
    const double margin = 1 + 1.05 * markers[i].radius * camera.focal_px();
    if (!(pixel.x() > margin && pixel.x() < size.width_px - 1 - margin)) return false;
    if (!(pixel.y() > margin && pixel.y() < size.height_px - 1 - margin)) return false;
    for (std::size_t k = 0; k < i; ++k) {
      const double apart = kCard * (markers[i].radius + markers[k].radius);
      if ((markers[i].s - markers[k].s).norm() < apart) return false;
    }
  }
  return true;
}

/// The object turned any way about the markers' mean normal, tilted up to the limit, anywhere in the image, its joints
/// anywhere within their limits; tried until every marker is in view.
template <class M>
model::Configuration<M, double> random_view(const vision::CameraModel<double>& camera, const ViewLimits& limits,
                                            Random& random) {
  const auto& size = camera.parameters();
  for (;;) {
    model::Configuration<M, double> q;
    for (int j = 0; j < model::kNumJoints<M>; ++j) {
      const auto range = tracker::joint_range<M, double>(j);
      q.joints[j] = random.uniform(range.low, range.high);
    }
    const auto kinematics = model::forward_kinematics<M, double>(q.joints);
    Vec<double, 3> middle = Vec<double, 3>::Zero(), normal = Vec<double, 3>::Zero();
    for (const auto& marker : kinematics.markers) middle += marker.centre, normal += marker.normal;
    middle /= static_cast<double>(kinematics.markers.size());
    const double z_m = random.uniform(limits.nearest_m, limits.farthest_m);
    const Vec<double, 3> at = z_m * Vec<double, 3>{(random.uniform(0, size.width_px) - size.cx_px) / size.fx_px,
                                                   (random.uniform(0, size.height_px) - size.cy_px) / size.fy_px, 1};
    const Vec<double, 3> facing = -at.normalized(), aside = facing.unitOrthogonal();
    // Even over the sphere of directions.
    const double tilt = std::acos(random.uniform(std::cos(limits.max_tilt_rad), 1));
    const double turn = random.uniform(-std::numbers::pi, std::numbers::pi),
                 roll = random.uniform(-std::numbers::pi, std::numbers::pi);
    q.T_cam_obj.R = Quat<double>(Eigen::AngleAxisd(turn, facing) * Eigen::AngleAxisd(tilt, aside) *
                                 Eigen::AngleAxisd(roll, facing)) *
                    Quat<double>::FromTwoVectors(normal, facing);
    q.T_cam_obj.t = at - q.T_cam_obj.R * middle;
    if (shows_all<M>(q, camera, limits.max_tilt_rad)) return q;
  }
}

/// The detection of an ellipse seen through a pinhole; its centre and axes off by `deviation_px` each.
inline vision::Detection detection_of(vision::MarkKind kind, const Vec<double, 2>& s,
                                      const tracker::Shape<double>& shape, const CameraParameters& camera,
                                      double deviation_px, Random& random) {
  Mat<double, 2, 2> moments;
  moments << shape[0] * camera.fx_px * camera.fx_px, shape[1] * camera.fx_px * camera.fy_px,
      shape[1] * camera.fx_px * camera.fy_px, shape[2] * camera.fy_px * camera.fy_px;
  vision::PlaneEllipse<double> ellipse;
  ellipse.centre = {camera.fx_px * s.x() + camera.cx_px + deviation_px * random.gaussian(),
                    camera.fy_px * s.y() + camera.cy_px + deviation_px * random.gaussian()};
  ellipse.M = moments.llt().matrixL();
  ellipse.M(0, 0) += deviation_px * random.gaussian();
  ellipse.M(1, 0) += deviation_px * random.gaussian();
  ellipse.M(1, 1) += deviation_px * random.gaussian();
  vision::Detection detection;
  detection.kind = kind;
  detection.outer = vision::to_q16(ellipse);
  detection.centre_variance_q24 = detection.axis_variance_q24 =
      static_cast<std::uint32_t>((1 << 24) * deviation_px * deviation_px + 1);
  return detection;
}

/// What a perfect detector sees of a configuration: one detection for each visible marker, in the table's order.
template <class M>
vision::Detections detections_of(const model::Configuration<M, double>& q, const vision::CameraModel<double>& camera,
                                 double deviation_px, Random& random) {
  vision::Detections detections;
  const auto markers = tracker::appear<M, double>(q, camera);
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (!markers[m].visible) continue;
    (void)detections.push_back(detection_of(tracker::mark_kind(M::kMarkers[m].kind), markers[m].s, markers[m].shape,
                                            camera.parameters(), deviation_px, random));
  }
  return detections;
}

/// A mark that is no marker, anywhere in the image, of 8 to 40 px across.
inline vision::Detection clutter(vision::MarkKind kind, const CameraParameters& camera, Random& random) {
  const double radius = random.uniform(4, 20) / camera.fx_px, flat = random.uniform(0.5, 1);
  const Vec<double, 2> s{(random.uniform(25, camera.width_px - 25) - camera.cx_px) / camera.fx_px,
                         (random.uniform(25, camera.height_px - 25) - camera.cy_px) / camera.fy_px};
  return detection_of(kind, s, {radius * radius, 0, flat * flat * radius * radius}, camera, 0.02, random);
}

}  // namespace articam::test
