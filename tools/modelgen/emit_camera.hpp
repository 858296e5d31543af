#pragma once
/// @file  CameraParameters -> a C++ header.

#include <string>

#include "core/camera_parameters.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {

/// `articam::cameras::k<type_name>`, a constexpr CameraParameters, below a comment that names the source with its hash.
std::string emit_camera(const CameraParameters& camera, const SourceFile& source, const std::string& type_name);

}  // namespace articam::modelgen
