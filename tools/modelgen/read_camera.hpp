#pragma once
/// @file  ROS calibration YAML -> CameraParameters.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/camera_parameters.hpp"
#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {

/// ROS's words, in the order of DistortionModel; their coefficients are 5, 8 and 4.
inline constexpr std::array<std::string_view, 3> kDistortionModels{"plumb_bob", "rational_polynomial", "equidistant"};

/// Keys  image_width, image_height, camera_matrix, distortion_model, distortion_coefficients; optional
///       T_base_cam, and readout_time_s, which serves V4L2 devices that stamp the end of a frame and nothing else (a
///       warning says so). What ROS writes besides (rectification, projection) is not used: the estimator reads raw
///       images.
/// Errors  missing or malformed values, a skewed camera matrix, a focal length outside 1 to 1e5 px, a principal point
///         farther off than 10 image sizes, images larger than the build takes, a distortion model not in
///         kDistortionModels. All of them are told in one run.
std::optional<CameraParameters> read_camera(const SourceFile& source, Diagnostics& diagnostics);

/// The same from a path.
std::optional<CameraParameters> read_camera(const std::string& path, Diagnostics& diagnostics);

}  // namespace articam::modelgen
