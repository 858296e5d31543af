#pragma once
/// @file  The ellipse that a mark may have -> ring, dot or nothing, measured on the grey levels.

#include "core/vision/detection.hpp"
#include "core/vision/hole_offset.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

/// A ring near `seed`, its outer edge, with a hole of the given ratio. `budget` is reduced by what the fits cost.
bool measure_ring(const ImageView& image, const Ellipse& seed, std::int32_t ratio_q16, const Pinhole& camera,
                  int& budget, Detection& out) noexcept;

/// A dot near `seed`, light on dark or dark on light.
bool measure_dot(const ImageView& image, const Ellipse& seed, bool light, int& budget, Detection& out) noexcept;

}  // namespace articam::vision
