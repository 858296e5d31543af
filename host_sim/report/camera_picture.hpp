#pragma once
/// @file  One camera frame for the page, with the marks' outlines drawn over it.

#include <span>
#include <string>

#include "core/vision/image_view.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// An inline SVG: the frame as an embedded PNG, under the outlines of marks at an estimated configuration. Empty
/// where the image may not be read.
std::string camera_picture(const ImageView& image, const CameraParameters& camera,
                           std::span<const SceneMarker> outlined);

}  // namespace articam::sim
