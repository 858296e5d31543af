#include "hal/capture/luma_layout.hpp"

#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <set>
#include <vector>

namespace articam {
namespace {

using hal::fourcc;
using hal::preferred_layout;

TEST(LumaLayout, PrefersAPlaneOfLumaToInterleavedLumaAndThatToGreen) {
  const std::array all{fourcc("MJPG"), fourcc("RG24"), fourcc("YUYV"), fourcc("NV12")};
  const std::span<const std::uint32_t> offered{all};
  EXPECT_EQ(preferred_layout(offered)->name, "NV12");
  EXPECT_EQ(preferred_layout(offered.first(3))->name, "YUYV");
  EXPECT_EQ(preferred_layout(offered.first(2))->name, "RGB888");
  EXPECT_EQ(preferred_layout(offered.first(1)), nullptr);
}

TEST(LumaLayout, OfEveryFormatStaysWithinTheBytesThatItSaysItNeeds) {
  constexpr int kWidth_px = 6, kHeight_px = 3;
  for (const auto& layout : hal::kLumaLayouts) {
    const std::size_t stride = static_cast<std::size_t>(kWidth_px * layout.step) + 5;
    std::vector<std::uint8_t> from(hal::bytes_needed(layout, kWidth_px, kHeight_px, stride), 0);
    for (int v = 0; v < kHeight_px; ++v) {
      for (int u = 0; u < kWidth_px; ++u) {
        from.at(std::size_t(v) * stride + std::size_t(layout.first + u * layout.step)) = std::uint8_t(10 * v + u + 1);
      }
    }
    std::vector<std::uint8_t> to(kWidth_px * kHeight_px);
    copy_luma(layout, from.data(), stride, kWidth_px, kHeight_px, to.data());
    for (int v = 0; v < kHeight_px; ++v) {
      for (int u = 0; u < kWidth_px; ++u) EXPECT_EQ(to[std::size_t(v * kWidth_px + u)], 10 * v + u + 1) << layout.name;
    }
  }
}

TEST(LumaLayout, WritesItsCodesAsTheHeadersOfDrmAndV4l2Do) {
  EXPECT_EQ(fourcc("NV12"), 0x3231564eu);  // DRM_FORMAT_NV12
  for (const std::uint32_t format :
       {V4L2_PIX_FMT_GREY, V4L2_PIX_FMT_NV12, V4L2_PIX_FMT_NV21, V4L2_PIX_FMT_NV16, V4L2_PIX_FMT_NV61,
        V4L2_PIX_FMT_YUV420, V4L2_PIX_FMT_YVU420, V4L2_PIX_FMT_YUV422P, V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_YVYU,
        V4L2_PIX_FMT_UYVY, V4L2_PIX_FMT_VYUY, V4L2_PIX_FMT_RGB24, V4L2_PIX_FMT_BGR24, V4L2_PIX_FMT_XBGR32,
        V4L2_PIX_FMT_XRGB32, V4L2_PIX_FMT_RGBX32, V4L2_PIX_FMT_BGRX32}) {
    EXPECT_NE(preferred_layout(std::array{format}), nullptr) << format;
  }
}

TEST(LumaLayout, HasNoCodeTwice) {
  std::set<std::uint32_t> codes;
  for (const auto& layout : hal::kLumaLayouts) EXPECT_TRUE(codes.insert(layout.format).second) << layout.name;
}

}  // namespace
}  // namespace articam
