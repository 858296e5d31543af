#pragma once
/// @file  Traced region -> ring, dot or nothing.

#include "core/vision/bit_mask.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/region.hpp"

namespace articam::vision {

/// Where the mask's pixel (0, 0) lies in the image.
struct Origin {
  int u_px{}, v_px{};
};

/// A ring whose dark outline is `region`, with a hole of the given ratio.
bool find_ring(const ImageView& image, const BitMask& mask, Origin origin, const Region& region, std::int32_t ratio_q16,
               Detection& out) noexcept;

/// A dot of the region's colour.
bool find_dot(const ImageView& image, Origin origin, const Region& region, Detection& out) noexcept;

}  // namespace articam::vision
