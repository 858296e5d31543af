#include "tools/picture/draw.hpp"

#include <gtest/gtest.h>

#include <cairo.h>

#include <cstring>
#include <memory>
#include <string_view>

namespace articam::picture {
namespace {

constexpr CameraParameters kCamera{
    .width_px = 64, .height_px = 48, .fx_px = 50, .fy_px = 50, .cx_px = 31.5, .cy_px = 23.5};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

Surface decode(std::string_view png) {
  const auto read = [](void* rest, unsigned char* out, unsigned int size) {
    auto& bytes = *static_cast<std::string_view*>(rest);
    if (bytes.size() < size) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(out, bytes.data(), size);
    bytes.remove_prefix(size);
    return CAIRO_STATUS_SUCCESS;
  };
  return {cairo_image_surface_create_from_png_stream(read, &png), &cairo_surface_destroy};
}

unsigned red(const Surface& picture, int u, int v) {
  const auto* row = cairo_image_surface_get_data(picture.get()) + v * cairo_image_surface_get_stride(picture.get());
  std::uint32_t pixel{};
  std::memcpy(&pixel, row + 4 * u, sizeof pixel);
  return pixel >> 16U & 255U;
}

TEST(Draw, PutsAShapeWhereTheCameraProjectsItAndNothingElsewhere) {
  Scene scene;
  // 10 px wide about the pixel (41.5, 13.5), between columns 36.5 and 46.5, rows 8.5 and 18.5.
  scene.shapes.push_back(
      {.form = Form::box, .T_cam_shape = {{1, 0, 0, 0}, {0.2, -0.2, 1.0005}}, .size = {0.2, 0.2, 0.001}});
  const Surface picture = decode(draw(scene, kCamera, kCamera.width_px));
  ASSERT_EQ(cairo_image_surface_get_width(picture.get()), 64);
  ASSERT_EQ(cairo_image_surface_get_height(picture.get()), 48);
  int dark = 0;
  for (int v = 0; v < 48; ++v) {
    for (int u = 0; u < 64; ++u) dark += red(picture, u, v) < 128 ? 1 : 0;
  }
  EXPECT_EQ(dark, 100);
  EXPECT_LT(red(picture, 37, 9), 128u);
  EXPECT_LT(red(picture, 46, 18), 128u);
}

TEST(Draw, ScalesTheWholeView) {
  const Surface picture = decode(draw({}, kCamera, 32));
  EXPECT_EQ(cairo_image_surface_get_width(picture.get()), 32);
  EXPECT_EQ(cairo_image_surface_get_height(picture.get()), 24);
  EXPECT_EQ(red(picture, 16, 12), 255u);
}

}  // namespace
}  // namespace articam::picture
