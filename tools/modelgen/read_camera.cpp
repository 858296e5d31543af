#include "tools/modelgen/read_camera.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/config.hpp"
#include "tools/modelgen/read_yaml.hpp"

namespace articam::modelgen {
namespace {

int read_size(YamlMap& map, const char* key, int largest) {
  const auto value = map.number(key);
  if (!value) return 0;
  if (*value != std::floor(*value) || *value < 1) {
    map.error(map.line_of_key(key), key, fmt::format("{} is not a whole number of pixels", *value));
    return 0;
  }
  if (*value > largest) {
    map.error(map.line_of_key(key), key, fmt::format("{} exceeds {}, the largest this build takes", *value, largest));
    return 0;
  }
  return static_cast<int>(*value);
}

/// A ROS matrix {rows, cols, data}: its data if it has this many rows and columns.
std::optional<std::vector<double>> read_matrix(YamlMap& map, const SourceFile& source, const char* key, int rows,
                                               int cols, Diagnostics& diagnostics) {
  if (!map.has(key)) {
    map.error(map.line(), key, "is missing");
    return std::nullopt;
  }
  YamlMap matrix(source, map.get(key), key, diagnostics);
  matrix.check_keys({"rows", "cols", "data"}, YamlMap::UnknownKeys::refuse);
  const auto is = [&](const char* name, int size) {
    const auto value = matrix.number(name);
    if (value && *value != size) matrix.error(matrix.line_of_key(name), name, fmt::format("is not {}", size));
  };
  is("rows", rows);
  is("cols", cols);
  return matrix.numbers("data", static_cast<std::size_t>(rows * cols));
}

void read_intrinsics(YamlMap& map, const SourceFile& source, CameraParameters& camera, Diagnostics& diagnostics) {
  const auto K = read_matrix(map, source, "camera_matrix", 3, 3, diagnostics);
  if (!K) return;
  const auto refuse = [&](const char* reason) { map.error(map.line_of_key("camera_matrix"), "camera_matrix", reason); };
  const auto& k = *K;
  if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1) refuse("is not (fx 0 cx, 0 fy cy, 0 0 1)");
  const auto no_focal_length = [](double f) { return !(f >= 1 && f <= 1e5); };
  if (no_focal_length(k[0]) || no_focal_length(k[4])) refuse("has a focal length that is not between 1 and 1e5 px");
  const auto off = [](double c, int size) { return size > 0 && std::abs(c) > 10 * size; };
  if (off(k[2], camera.width_px) || off(k[5], camera.height_px)) refuse("has a principal point far outside the image");
  camera.fx_px = k[0];
  camera.fy_px = k[4];
  camera.cx_px = k[2];
  camera.cy_px = k[5];
}

void read_distortion(YamlMap& map, const SourceFile& source, CameraParameters& camera, Diagnostics& diagnostics) {
  const auto model = map.text("distortion_model");
  if (!model) return;
  const auto known = std::find(kDistortionModels.begin(), kDistortionModels.end(), *model);
  if (known == kDistortionModels.end()) {
    map.error(map.line_of_key("distortion_model"), "distortion_model",
              fmt::format("'{}' is not known; known are {}", *model, fmt::join(kDistortionModels, ", ")));
    return;
  }
  camera.distortion_model = static_cast<DistortionModel>(known - kDistortionModels.begin());
  const auto d = read_matrix(map, source, "distortion_coefficients", 1,
                             static_cast<int>(num_coefficients(camera.distortion_model)), diagnostics);
  if (d) std::copy(d->begin(), d->end(), camera.distortion.begin());
}

void read_base(YamlMap& map, const SourceFile& source, CameraParameters& camera, Diagnostics& diagnostics) {
  if (!map.has("T_base_cam")) return;
  camera.has_t_base_cam = true;
  YamlMap pose(source, map.get("T_base_cam"), "T_base_cam", diagnostics);
  pose.check_keys({"position", "quaternion_wxyz"}, YamlMap::UnknownKeys::refuse);
  if (const auto t = pose.numbers("position", 3)) std::copy(t->begin(), t->end(), camera.t_base_cam_m.begin());
  const auto r = pose.numbers("quaternion_wxyz", 4);
  if (!r) return;
  const double norm = std::sqrt((*r)[0] * (*r)[0] + (*r)[1] * (*r)[1] + (*r)[2] * (*r)[2] + (*r)[3] * (*r)[3]);
  if (!(std::abs(norm - 1) < 1e-3)) {
    pose.error(pose.line_of_key("quaternion_wxyz"), "quaternion_wxyz", fmt::format("has norm {:.6g}, not 1", norm));
    return;
  }
  std::transform(r->begin(), r->end(), camera.r_base_cam_wxyz.begin(), [norm](double x) { return x / norm; });
}

}  // namespace

std::optional<CameraParameters> read_camera(const SourceFile& source, Diagnostics& diagnostics) {
  Diagnostics found;
  CameraParameters camera;
  if (const auto document = read_yaml(source, found)) {
    YamlMap map(source, *document, "", found);
    map.check_keys(
        {"image_width", "image_height", "camera_name", "camera_matrix", "distortion_model", "distortion_coefficients",
         "rectification_matrix", "projection_matrix", "binning_x", "binning_y", "roi", "readout_time_s", "T_base_cam"},
        YamlMap::UnknownKeys::tolerate);
    camera.width_px = read_size(map, "image_width", kMaxImageWidth_px);
    camera.height_px = read_size(map, "image_height", kMaxImageHeight_px);
    read_intrinsics(map, source, camera, found);
    read_distortion(map, source, camera, found);
    if (map.has("readout_time_s")) {
      camera.readout_time_s = map.number("readout_time_s").value_or(0);
      if (!(camera.readout_time_s >= 0 && camera.readout_time_s < 1)) {
        map.error(map.line_of_key("readout_time_s"), "readout_time_s", "is not between 0 and 1 s");
      }
    }
    read_base(map, source, camera, found);
    if (map.has("readout_time_s")) {
      found.warning(source.path, map.line_of_key("readout_time_s"), "readout_time_s",
                    "dates frames of V4L2 devices that stamp their end; the rows of a frame count as of one instant");
    }
  }
  diagnostics.append(found);
  return found.has_errors() ? std::nullopt : std::optional(camera);
}

std::optional<CameraParameters> read_camera(const std::string& path, Diagnostics& diagnostics) {
  const auto source = read_source(path, diagnostics);
  return source ? read_camera(*source, diagnostics) : std::nullopt;
}

}  // namespace articam::modelgen
