#pragma once
/// @file  The pixels around some points of an image.

#include <algorithm>

#include "core/camera_parameters.hpp"
#include "core/math/types.hpp"
#include "core/vision/image_view.hpp"

namespace articam::sim {

class PixelBounds {
 public:
  void add(const Vec<double, 2>& pixel) noexcept {
    low_ = low_.cwiseMin(pixel);
    high_ = high_.cwiseMax(pixel);
  }

  /// With a pixel more on every side; empty where that is outside the image.
  PixelBox within(const CameraParameters& camera) const noexcept {
    const double width = camera.width_px, height = camera.height_px;
    return {static_cast<int>(std::clamp(low_.x() - 1, 0.0, width)),
            static_cast<int>(std::clamp(low_.y() - 1, 0.0, height)),
            static_cast<int>(std::clamp(high_.x() + 2, -1.0, width - 1)),
            static_cast<int>(std::clamp(high_.y() + 2, -1.0, height - 1))};
  }

 private:
  Vec<double, 2> low_{1e6, 1e6}, high_{-1e6, -1e6};
};

}  // namespace articam::sim
