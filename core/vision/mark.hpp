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

/// What the fit of a ring's edge takes of the budget of work. A dot's takes a quarter: clutter holds many candidates,
/// most of which fail in the first of the four steps.
inline constexpr int kRowsPerFit = 64;

/// A ring whose dark outline is `region`, with a hole of the given ratio. `budget` is reduced by each fit.
bool find_ring(const ImageView& image, const BitMask& mask, Origin origin, const Region& region, std::int32_t ratio_q16,
               int& budget, Detection& out) noexcept;

/// A dot of the region's colour. `budget` is reduced by each fit.
bool find_dot(const ImageView& image, Origin origin, const Region& region, int& budget, Detection& out) noexcept;

}  // namespace articam::vision
