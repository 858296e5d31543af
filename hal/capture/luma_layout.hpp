#pragma once
/// @file  Where the brightness of a pixel lies in the pixel formats that a camera may offer.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace articam::hal {

/// Four characters as drm_fourcc.h and videodev2.h count them.
constexpr std::uint32_t fourcc(const char (&text)[5]) noexcept {
  std::uint32_t code = 0;
  for (int i = 3; i >= 0; --i) code = code << 8 | static_cast<std::uint8_t>(text[i]);
  return code;
}

/// Pixel u of a row is at byte first + u * step of its row in the first plane.
struct LumaLayout {
  std::uint32_t format;  ///< fourcc
  std::ptrdiff_t first;
  std::ptrdiff_t step;
  std::string_view name;

  constexpr bool in_place() const noexcept { return first == 0 && step == 1; }
  constexpr bool is_luma() const noexcept { return step <= 2; }  ///< else green stands in for it

  /// For a log.
  constexpr std::string_view how_lent() const noexcept {
    if (in_place()) return "luma in place";
    return is_luma() ? "luma copied: it lies between the chroma"
                     : "GREEN COPIED: the camera offers no luma, colours will be seen as their green";
  }
};

/// In the order of preference: a plane of luma, luma between chroma, the green of a colour image. Compressed, packed
/// 10-bit and raw Bayer formats are not here and never chosen. Where libcamera (DRM) and V4L2 call one layout by two
/// codes both are here; no code means two layouts.
inline constexpr std::array<LumaLayout, 22> kLumaLayouts{{
    {fourcc("R8  "), 0, 1, "R8"},       {fourcc("GREY"), 0, 1, "GREY"},     {fourcc("NV12"), 0, 1, "NV12"},
    {fourcc("NV21"), 0, 1, "NV21"},     {fourcc("YU12"), 0, 1, "YUV420"},   {fourcc("YV12"), 0, 1, "YVU420"},
    {fourcc("NV16"), 0, 1, "NV16"},     {fourcc("NV61"), 0, 1, "NV61"},     {fourcc("YU16"), 0, 1, "YUV422"},
    {fourcc("422P"), 0, 1, "YUV422P"},  {fourcc("YUYV"), 0, 2, "YUYV"},     {fourcc("YVYU"), 0, 2, "YVYU"},
    {fourcc("UYVY"), 1, 2, "UYVY"},     {fourcc("VYUY"), 1, 2, "VYUY"},     {fourcc("BG24"), 1, 3, "BGR888"},
    {fourcc("RG24"), 1, 3, "RGB888"},   {fourcc("RGB3"), 1, 3, "RGB24"},    {fourcc("BGR3"), 1, 3, "BGR24"},
    {fourcc("XR24"), 1, 4, "XRGB8888"}, {fourcc("XB24"), 1, 4, "XBGR8888"}, {fourcc("RX24"), 2, 4, "RGBX8888"},
    {fourcc("BX24"), 2, 4, "BGRX8888"},
}};

/// The layout to ask for among the formats that a camera offers; nullptr when none will do.
constexpr const LumaLayout* preferred_layout(std::span<const std::uint32_t> offered) noexcept {
  for (const LumaLayout& layout : kLumaLayouts) {
    for (const std::uint32_t format : offered) {
      if (format == layout.format) return &layout;
    }
  }
  return nullptr;
}

/// Bytes of the first plane that a width x height image needs; the last row may lack its padding.
constexpr std::size_t bytes_needed(const LumaLayout& layout, int width_px, int height_px, std::size_t stride) noexcept {
  return stride * static_cast<std::size_t>(height_px - 1) + static_cast<std::size_t>(width_px * layout.step);
}

/// Copies the luma (or green) of an interleaved image into one with rows of width_px bytes.
inline void copy_luma(const LumaLayout& layout, const std::uint8_t* from, std::size_t stride, int width_px,
                      int height_px, std::uint8_t* to) noexcept {
  for (int v = 0; v < height_px; ++v, from += stride, to += width_px) {
    for (int u = 0; u < width_px; ++u) to[u] = from[layout.first + u * layout.step];
  }
}

}  // namespace articam::hal
