#pragma once
/// @file  What a ROS calibration file says of a camera, as plain numbers.

#include <array>
#include <cstddef>
#include <cstdint>

namespace articam {

/// The lens models of ROS, with OpenCV's formulas and order of coefficients; core/vision/lens.hpp has them.
enum class DistortionModel : std::uint8_t {
  plumb_bob,            ///< k1 k2 p1 p2 k3
  rational_polynomial,  ///< k1 k2 p1 p2 k3 k4 k5 k6
  equidistant,          ///< k1 k2 k3 k4: a fisheye
};

constexpr std::size_t num_coefficients(DistortionModel model) noexcept {
  switch (model) {
    case DistortionModel::plumb_bob:
      return 5;
    case DistortionModel::rational_polynomial:
      return 8;
    case DistortionModel::equidistant:
      return 4;
  }
  return 0;
}

/// Intrinsics of one camera. Units: px unless a suffix says otherwise; distortion without unit.
/// Pixel centres are integers, (0, 0) is the centre of the top-left pixel.
struct CameraParameters {
  int width_px{};
  int height_px{};
  double fx_px{}, fy_px{};  ///< focal lengths
  double cx_px{}, cy_px{};  ///< principal point
  DistortionModel distortion_model{DistortionModel::plumb_bob};
  std::array<double, 8> distortion{};  ///< the first num_coefficients() of it; 0 beyond

  double readout_time_s{};  ///< rolling shutter, first to last row; 0 is a global shutter

  /// Camera in the robot's control frame {base}; identity where the file does not say.
  bool has_t_base_cam{};
  std::array<double, 3> t_base_cam_m{};
  std::array<double, 4> r_base_cam_wxyz{1, 0, 0, 0};
};

}  // namespace articam
