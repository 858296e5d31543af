#pragma once
/// @file  Rendered frames of markers whose true image ellipses are known.

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "core/vision/detection.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::test {

inline constexpr CameraParameters kVga{
    .width_px = 640, .height_px = 480, .fx_px = 525, .fy_px = 525, .cx_px = 319.5, .cy_px = 239.5};
inline constexpr double kRadius_m = 0.025;
inline constexpr double kWhyConRatio = 50.0 / 122.0;

struct TrueEllipse {
  double u_px, v_px, major_px, minor_px;  ///< semi-axes
};

/// The image of a circle: its dual conic is K (c c^T - r^2 (I - n n^T)) K^T.
inline TrueEllipse imaged(const sim::SceneMarker& marker, double radius_m, const CameraParameters& camera = kVga) {
  const Vec<double, 3> c = marker.centre_cam_m, n = marker.normal_cam;
  Mat<double, 3, 3> K;
  K << camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1;
  const Mat<double, 3, 3> dual =
      K * (c * c.transpose() - radius_m * radius_m * (Mat<double, 3, 3>::Identity() - n * n.transpose())) *
      K.transpose();
  const Vec<double, 2> centre = dual.topRightCorner<2, 1>() / dual(2, 2);
  const Mat<double, 2, 2> shape = centre * centre.transpose() - dual.topLeftCorner<2, 2>() / dual(2, 2);
  const Eigen::SelfAdjointEigenSolver<Mat<double, 2, 2>> axes(shape);
  return {centre.x(), centre.y(), std::sqrt(axes.eigenvalues()(1)), std::sqrt(axes.eigenvalues()(0))};
}

inline TrueEllipse measured(const vision::Ellipse& e) {
  Mat<double, 2, 2> m;
  m << vision::from_q16(e.m00_q16), 0, vision::from_q16(e.m10_q16), vision::from_q16(e.m11_q16);
  const Eigen::SelfAdjointEigenSolver<Mat<double, 2, 2>> axes(m * m.transpose());
  return {vision::from_q16(e.u_q16), vision::from_q16(e.v_q16), std::sqrt(axes.eigenvalues()(1)),
          std::sqrt(axes.eigenvalues()(0))};
}

/// columns x rows markers of that untilted diameter, spread over the frame and shifted, each tilted in a random
/// direction.
inline std::vector<sim::SceneMarker> grid_of_markers(model::MarkerKind kind, int columns, int rows, double diameter_px,
                                                     double tilt_rad, std::mt19937& random) {
  const auto uniform = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<sim::SceneMarker> markers;
  const double z_m = kVga.fx_px * 2 * kRadius_m / diameter_px;
  const double pitch_u_px = 640.0 / columns, pitch_v_px = 480.0 / rows;
  for (int i = 0; i < columns * rows; ++i) {
    const double free_u_px = std::max(pitch_u_px - 1.5 * diameter_px, 1.0),
                 free_v_px = std::max(pitch_v_px - 1.5 * diameter_px, 1.0);
    const double u = (i % columns + 0.5) * pitch_u_px + (uniform() - 0.5) * free_u_px;
    const double v = (i / columns + 0.5) * pitch_v_px + (uniform() - 0.5) * free_v_px;
    const Vec<double, 3> centre = z_m * Vec<double, 3>{(u - kVga.cx_px) / kVga.fx_px, (v - kVga.cy_px) / kVga.fy_px, 1};
    const Vec<double, 3> facing = -centre.normalized();
    const Vec<double, 3> normal = Eigen::AngleAxisd(2 * std::numbers::pi * uniform(), facing) *
                                  (Eigen::AngleAxisd(tilt_rad, facing.unitOrthogonal()) * facing);
    markers.push_back(
        {kind, centre, normal, kRadius_m, kind == model::MarkerKind::ring ? kRadius_m * kWhyConRatio : 0});
  }
  return markers;
}

/// Lets all move by so much while a frame is exposed as by default.
inline void set_moving(std::vector<sim::SceneMarker>& markers, const Vec<double, 2>& way_px) {
  for (sim::SceneMarker& marker : markers) {
    const double px_per_mps = kVga.fx_px / marker.centre_cam_m.z() * sim::RenderOptions{}.exposure_time_s;
    marker.velocity = {way_px.x() / px_per_mps, way_px.y() / px_per_mps, 0};
  }
}

inline ImageView view_of(const std::vector<std::uint8_t>& pixels, const CameraParameters& camera = kVga) {
  return {pixels.data(), camera.width_px, camera.height_px, camera.width_px};
}

}  // namespace articam::test
