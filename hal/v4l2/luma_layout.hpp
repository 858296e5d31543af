#pragma once
/// @file  Where luma lies in the pixel formats of V4L2 that are taken.

#include <linux/videodev2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace articam::hal::v4l2 {

/// Pixel u of a row is at byte first + u * step of its row.
struct LumaLayout {
  std::uint32_t format;  ///< V4L2_PIX_FMT_*
  std::ptrdiff_t first;
  std::ptrdiff_t step;

  constexpr bool in_place() const noexcept { return first == 0 && step == 1; }
};

/// In the order of preference: a plane of luma is lent in place, luma between chroma is copied out.
inline constexpr std::array<LumaLayout, 10> kLumaLayouts{{
    {V4L2_PIX_FMT_GREY, 0, 1},
    {V4L2_PIX_FMT_NV12, 0, 1},
    {V4L2_PIX_FMT_NV21, 0, 1},
    {V4L2_PIX_FMT_YUV420, 0, 1},
    {V4L2_PIX_FMT_YVU420, 0, 1},
    {V4L2_PIX_FMT_YUV422P, 0, 1},
    {V4L2_PIX_FMT_YUYV, 0, 2},
    {V4L2_PIX_FMT_YVYU, 0, 2},
    {V4L2_PIX_FMT_UYVY, 1, 2},
    {V4L2_PIX_FMT_VYUY, 1, 2},
}};

/// nullptr when none of the formats offered will do.
constexpr const LumaLayout* preferred_layout(std::span<const std::uint32_t> offered) noexcept {
  for (const LumaLayout& layout : kLumaLayouts) {
    for (const std::uint32_t format : offered) {
      if (format == layout.format) return &layout;
    }
  }
  return nullptr;
}

}  // namespace articam::hal::v4l2
