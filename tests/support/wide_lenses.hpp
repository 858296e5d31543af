#pragma once
/// @file  Cameras of each lens model, 85 degrees across and more.

#include <array>

#include "core/camera_parameters.hpp"

namespace articam::test {

inline CameraParameters camera_with(DistortionModel model, const std::array<double, 8>& distortion) {
  CameraParameters p;
  p.width_px = 640, p.height_px = 480;
  p.fx_px = 410, p.fy_px = 405, p.cx_px = 322, p.cy_px = 236;
  p.distortion_model = model;
  p.distortion = distortion;
  return p;
}

/// One camera of each lens model.
inline std::array<CameraParameters, 3> wide_lenses() {
  return {camera_with(DistortionModel::plumb_bob, {-0.31, 0.11, 0.0012, -0.0007, -0.018}),
          camera_with(DistortionModel::rational_polynomial, {0.6, 0.1, 0.001, -0.001, 0.01, 0.9, 0.2, 0.03}),
          camera_with(DistortionModel::equidistant, {-0.02, 0.01, -0.003, 0.001})};
}

}  // namespace articam::test
