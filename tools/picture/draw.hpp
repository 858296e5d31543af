#pragma once
/// @file  A scene -> a picture of it, for people.

#include <string>

#include "core/camera_parameters.hpp"
#include "tools/picture/scene.hpp"

namespace articam::picture {

/// PNG bytes: the camera's view, its lens without distortion, scaled to that width. A lamp stands beside the camera;
/// its shadows tell what stands before what.
std::string draw(const Scene& scene, const CameraParameters& camera, int width_px);

}  // namespace articam::picture
