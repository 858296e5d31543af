#include "host_sim/report/camera_picture.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "core/math/trigonometry.hpp"
#include "core/vision/camera_model.hpp"

namespace articam::sim {
namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::string png(const ImageView& image) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface{
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width_px, image.height_px), &cairo_surface_destroy};
  unsigned char* pixels = cairo_image_surface_get_data(surface.get());
  if (pixels == nullptr) return {};
  const int stride_bytes = cairo_image_surface_get_stride(surface.get());
  for (int v = 0; v < image.height_px; ++v) {
    auto* row = reinterpret_cast<std::uint32_t*>(pixels + static_cast<std::ptrdiff_t>(v) * stride_bytes);
    for (int u = 0; u < image.width_px; ++u) row[u] = image.row(v)[u] * 0x010101U;
  }
  cairo_surface_mark_dirty(surface.get());
  std::string bytes;
  const auto append = [](void* out, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  return bytes;
}

/// The image of a circle as an SVG path of short lines.
std::string outline(const SceneMarker& marker, const vision::CameraModel<double>& camera) {
  constexpr int kSides = 48;
  const Vec<double, 3> e1 = marker.normal_cam.unitOrthogonal(), e2 = marker.normal_cam.cross(e1);
  std::string path;
  for (int i = 0; i < kSides; ++i) {
    const auto turn = math::sin_cos(2 * 3.14159265358979323846 / kSides * i);
    const Vec<double, 3> p = marker.centre_cam_m + marker.outer_radius_m * (turn.cos * e1 + turn.sin * e2);
    if (!(p.z() > 0)) return {};
    const Vec<double, 2> pixel = camera.project(p.hnormalized());
    fmt::format_to(std::back_inserter(path), "{}{:.2f} {:.2f}", i == 0 ? "M" : "L", pixel.x(), pixel.y());
  }
  return path + "Z";
}

}  // namespace

std::string camera_picture(const ImageView& image, const CameraParameters& camera,
                           std::span<const SceneMarker> outlined) {
  if (!image.ok()) return {};
  const vision::CameraModel<double> model{camera};
  std::string paths;
  for (const SceneMarker& marker : outlined) paths += outline(marker, model);
  // SVG puts (0, 0) at the corner of the first pixel, we at its centre.
  return fmt::format(
      "<svg viewBox=\"-0.5 -0.5 {0} {1}\"><image x=\"-0.5\" y=\"-0.5\" width=\"{0}\" height=\"{1}\" "
      "href=\"data:image/png;base64,{2}\"/><path d=\"{3}\" fill=\"none\" stroke=\"#ff7b00\" "
      "stroke-width=\"1.5\"/></svg>",
      image.width_px, image.height_px, base64(png(image)), paths);
}

}  // namespace articam::sim
