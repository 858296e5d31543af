#pragma once
/// @file  Camera frames for the page, under what was measured and what was estimated there.

#include <span>
#include <string>
#include <vector>

#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// Part of an image, px.
struct Crop {
  int u{}, v{}, width{}, height{};
};

/// What is drawn over one frame.
struct Overlay {
  std::vector<vision::Ellipse> seen;          ///< edges as the detector measured them: yellow
  std::vector<SceneMarker> estimated, rival;  ///< at the estimate: blue; at that of the other mode: green
  std::string label;
};

/// Where these marks appear, and some pixels around; the whole image where none does.
Crop around(std::span<const Overlay> overlays, const CameraParameters& camera);

/// One frame as SVG elements: an embedded PNG, and the overlay. Empty where the image may not be read.
std::string picture_layers(const ImageView& image, const CameraParameters& camera, const Overlay& overlay,
                           const Crop& crop);

/// A whole SVG of one frame's layers.
std::string camera_picture(const std::string& layers, const Crop& crop);

/// A whole SVG that shows one frame's layers after another, again and again; in print, and for who wants no motion, the
/// first alone.
std::string camera_film(std::span<const std::string> frames, double period_s, const Crop& crop);

}  // namespace articam::sim
