#include "tools/picture/draw.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

namespace articam::picture {
namespace {

constexpr int kRaysAcross = 3;  ///< of a pixel: its colour is the mean of kRaysAcross^2 rays

Colour seen_along(const Vec3& direction, const Scene& scene) {
  constexpr Colour kBackground{1, 1, 1};
  constexpr double kAmbient = 0.65, kInShadow = 0.78;
  const Vec3 to_lamp = Vec3(-0.45, -0.6, -0.9).normalized();
  const auto sight = first_met({Vec3::Zero(), direction}, scene.shapes);
  if (!sight) return kBackground;
  const Hit& hit = sight->hit;
  double light = kAmbient + 0.4 * std::max(0.0, hit.normal_cam.dot(to_lamp));
  const Vec3 above = hit.t * direction + 1e-3 * hit.normal_cam;
  if (first_met({above, to_lamp}, scene.shapes)) light *= kInShadow;
  Colour colour = hit.colour;
  for (double& c : colour) c *= light;
  return colour;
}

std::uint32_t pixel_at(int u, int v, double scale, const Scene& scene, const CameraParameters& camera) {
  Colour sum{};
  for (int i = 0; i < kRaysAcross * kRaysAcross; ++i) {
    // Pixel centres are integers, in the camera's image and in this one.
    const double u_px = (u + (i % kRaysAcross + 0.5) / kRaysAcross) * scale - 0.5;
    const double v_px = (v + (i / kRaysAcross + 0.5) / kRaysAcross) * scale - 0.5;
    const Colour colour =
        seen_along({(u_px - camera.cx_px) / camera.fx_px, (v_px - camera.cy_px) / camera.fy_px, 1}, scene);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c] / (kRaysAcross * kRaysAcross);
  }
  std::uint32_t rgb = 0;
  for (const double c : sum) rgb = rgb << 8U | static_cast<std::uint32_t>(std::lround(255 * std::clamp(c, 0.0, 1.0)));
  return rgb;
}

}  // namespace

std::string draw(const Scene& scene, const CameraParameters& camera, int width_px) {
  const double scale = static_cast<double>(camera.width_px) / width_px;
  const int height_px = static_cast<int>(std::lround(camera.height_px / scale));
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface{
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px), &cairo_surface_destroy};
  unsigned char* const pixels = cairo_image_surface_get_data(surface.get());
  if (pixels == nullptr) return {};
  const int stride_bytes = cairo_image_surface_get_stride(surface.get());
  for (int v = 0; v < height_px; ++v) {
    auto* const row = reinterpret_cast<std::uint32_t*>(pixels + static_cast<std::ptrdiff_t>(v) * stride_bytes);
    for (int u = 0; u < width_px; ++u) row[u] = pixel_at(u, v, scale, scene, camera);
  }
  cairo_surface_mark_dirty(surface.get());
  std::string png;
  const auto append = [](void* out, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_write_to_png_stream(surface.get(), append, &png);
  return png;
}

}  // namespace articam::picture
