#pragma once
/// @file  Outlines of one colour in a mask, traced from their topmost run down.

#include <cstdint>

#include "core/vision/bit_mask.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/fixed_point.hpp"

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

/// What of its outline a ring's dark covers at least, from the top down to any row: 1 - ratio^2 of the whole, 0.9 of
/// that at the foot of the hole, and less for the pixels of a small one.
constexpr std::int32_t least_own_share_q16(std::int32_t ratio_q16) noexcept {
  return static_cast<std::int32_t>((kOne_q16 - (std::int64_t{ratio_q16} * ratio_q16 >> kQ16)) * 3 / 4);
}

/// Follows the outline whose topmost run is columns a .. b of row v.
/// Returns false when it touches the border of the mask, is hollower than `min_own_q16`, or joins a wider region that
/// another top leads to, and when `budget` is used up: one for each row walked and each eight runs compared.
bool trace_region(const BitMask& mask, Colour colour, int v, int a, int b, std::int32_t min_own_q16, int& budget,
                  Region& out) noexcept;

/// The ellipse of the same area moments as the region. Returns false when it is flatter than any mark, or
/// when the area and the moments are not those of one ellipse.
bool ellipse_of(const Region& region, Ellipse& out) noexcept;

}  // namespace articam::vision
