#pragma once
/// @file  Outlines of one colour in a mask, traced from their topmost run down.

#include <cstdint>

#include "core/vision/bit_mask.hpp"
#include "core/vision/detection.hpp"

namespace articam::vision {

/// The filled outline of a region: between its leftmost and rightmost pixel every row counts, holes included.
/// Sums run over pixels relative to (u0, v0), the region's first pixel, so that they stay small.
struct Region {
  Colour colour{};
  int u0_px{}, v0_px{};
  PixelBox box{};
  std::int64_t area{};  ///< pixels of the filled outline
  std::int64_t own{};   ///< those of the region's own colour
  std::int64_t sum_u{}, sum_v{}, sum_uu{}, sum_uv{}, sum_vv{};
};

/// Follows the outline whose topmost run is columns a .. b of row v.
/// Returns false when it touches the border of the mask or joins a wider region that another top leads to,
/// and when `budget` rows are used up; budget is reduced by the rows that were walked.
bool trace_region(const BitMask& mask, Colour colour, int v, int a, int b, int& budget, Region& out) noexcept;

/// The ellipse of the same area moments as the region. Returns false when it is flatter than any mark, or
/// when the area and the moments are not those of one ellipse.
bool ellipse_of(const Region& region, Ellipse& out) noexcept;

}  // namespace articam::vision
