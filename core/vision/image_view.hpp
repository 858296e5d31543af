#pragma once
/// @file  A grey image somebody else owns.

#include <cstddef>
#include <cstdint>

#include "core/config.hpp"

namespace articam {

/// 8-bit grey, row-major; row v starts at data + v * stride.
struct ImageView {
  const std::uint8_t* data{};
  int width_px{};
  int height_px{};
  std::ptrdiff_t stride_bytes{};

  /// A view that may be read: present, within the compile-time maximum, rows not overlapping.
  constexpr bool ok() const noexcept {
    return data != nullptr && width_px > 0 && height_px > 0 && width_px <= kMaxImageWidth_px &&
           height_px <= kMaxImageHeight_px && stride_bytes >= width_px;
  }
  constexpr const std::uint8_t* row(int v_px) const noexcept { return data + v_px * stride_bytes; }
};

/// Pixels u_min..u_max, v_min..v_max, both ends included.
struct PixelBox {
  int u_min_px{}, v_min_px{}, u_max_px{-1}, v_max_px{-1};

  constexpr bool empty() const noexcept { return u_min_px > u_max_px || v_min_px > v_max_px; }
  constexpr PixelBox clipped_to(const ImageView& image) const noexcept {
    return {u_min_px < 0 ? 0 : u_min_px, v_min_px < 0 ? 0 : v_min_px,
            u_max_px >= image.width_px ? image.width_px - 1 : u_max_px,
            v_max_px >= image.height_px ? image.height_px - 1 : v_max_px};
  }
};

}  // namespace articam
