#include "host_sim/report/camera_picture.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
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

/// A grey PNG.
std::string png(const ImageView& image, const Crop& crop) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface{
      cairo_image_surface_create(CAIRO_FORMAT_A8, crop.width, crop.height), &cairo_surface_destroy};
  unsigned char* pixels = cairo_image_surface_get_data(surface.get());
  if (pixels == nullptr) return {};
  const int stride_bytes = cairo_image_surface_get_stride(surface.get());
  for (int v = 0; v < crop.height; ++v) {
    const std::uint8_t* row = image.row(crop.v + v) + crop.u;
    std::copy(row, row + crop.width, pixels + static_cast<std::ptrdiff_t>(v) * stride_bytes);
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

using Outline = std::vector<Vec<double, 2>>;

template <class PointAt>
Outline outline(const PointAt& point_at) {
  constexpr int kSides = 40;
  Outline points;
  for (int i = 0; i < kSides; ++i) {
    const auto turn = math::sin_cos(2 * 3.14159265358979323846 / kSides * i);
    points.push_back(point_at(turn.cos, turn.sin));
  }
  return points;
}

/// The image of a marker's edge; empty where it is not before the camera.
Outline outline(const SceneMarker& marker, const vision::CameraModel<double>& camera) {
  if (!(marker.centre_cam_m.z() > marker.outer_radius_m)) return {};
  const Vec<double, 3> e1 = marker.normal_cam.unitOrthogonal(), e2 = marker.normal_cam.cross(e1);
  return outline([&](double c, double s) -> Vec<double, 2> {
    return camera.project((marker.centre_cam_m + marker.outer_radius_m * (c * e1 + s * e2)).hnormalized());
  });
}

Outline outline(const vision::Ellipse& edge) {
  using vision::from_q16;
  return outline([&](double c, double s) -> Vec<double, 2> {
    return {from_q16(edge.u_q16) + from_q16(edge.m00_q16) * c,
            from_q16(edge.v_q16) + from_q16(edge.m10_q16) * c + from_q16(edge.m11_q16) * s};
  });
}

void append(const Outline& points, std::string& path) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    fmt::format_to(std::back_inserter(path), "{}{:.2f} {:.2f}", i == 0 ? "M" : "L", points[i].x(), points[i].y());
  }
  if (!points.empty()) path += 'Z';
}

std::string path_of(const std::vector<SceneMarker>& markers, const vision::CameraModel<double>& camera,
                    std::string_view style) {
  std::string path;
  for (const SceneMarker& marker : markers) append(outline(marker, camera), path);
  return fmt::format("<path d=\"{}\" {}/>", path, style);
}

/// SVG puts (0, 0) at the corner of the first pixel, we at its centre.
std::string svg_of(const std::string& content, const Crop& crop, std::string_view attributes) {
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" {} viewBox=\"{} {} {} {}\">\n{}</svg>\n", attributes,
                     crop.u - 0.5, crop.v - 0.5, crop.width, crop.height, content);
}

}  // namespace

Crop around(std::span<const Overlay> overlays, const CameraParameters& camera) {
  constexpr double kMargin_px = 14;
  const vision::CameraModel<double> model{camera};
  double u0 = std::numeric_limits<double>::infinity(), v0 = u0, u1 = -u0, v1 = -u0;
  const auto add = [&](const Outline& points) {
    for (const Vec<double, 2>& p : points) {
      u0 = std::min(u0, p.x()), u1 = std::max(u1, p.x()), v0 = std::min(v0, p.y()), v1 = std::max(v1, p.y());
    }
  };
  for (const Overlay& overlay : overlays) {
    for (const SceneMarker& marker : overlay.estimated) add(outline(marker, model));
    for (const vision::Ellipse& edge : overlay.seen) add(outline(edge));
  }
  const auto inside = [](double x, int size) { return static_cast<int>(std::clamp(x, 0.0, 1.0 * size)); };
  const int left = inside(u0 - kMargin_px, camera.width_px), right = inside(u1 + kMargin_px, camera.width_px);
  const int top = inside(v0 - kMargin_px, camera.height_px), bottom = inside(v1 + kMargin_px, camera.height_px);
  if (!(u0 <= u1) || right - left < 16 || bottom - top < 16) return {0, 0, camera.width_px, camera.height_px};
  return {left, top, right - left, bottom - top};
}

std::string picture_layers(const ImageView& image, const CameraParameters& camera, const Overlay& overlay,
                           const Crop& crop) {
  if (!image.ok()) return {};
  const vision::CameraModel<double> model{camera};
  std::string seen;
  for (const vision::Ellipse& edge : overlay.seen) append(outline(edge), seen);
  const double em = 0.04 * crop.width;
  return fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{}\"/>",
                     crop.u - 0.5, crop.v - 0.5, crop.width, crop.height, base64(png(image, crop))) +
         fmt::format("<g fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"{:.2f}\">", 0.004 * crop.width) +
         fmt::format("<path d=\"{}\" stroke=\"#ffd400\" stroke-width=\"{:.2f}\"/>", seen, 0.012 * crop.width) +
         path_of(overlay.rival, model, "stroke=\"#00a878\" stroke-dasharray=\"6 3\"") +
         path_of(overlay.estimated, model, "stroke=\"#0050b0\"") + "</g>" +
         fmt::format(
             "<text x=\"{:.1f}\" y=\"{:.1f}\" font-family=\"sans-serif\" font-size=\"{:.1f}\" fill=\"#fff\" "
             "stroke=\"#222\" stroke-width=\"{:.1f}\" paint-order=\"stroke\">{}</text>\n",
             crop.u + 0.4 * em, crop.v + 1.2 * em, em, 0.2 * em, overlay.label);
}

std::string camera_picture(const std::string& layers, const Crop& crop) {
  return layers.empty() ? std::string{} : svg_of(layers, crop, "class=\"photo\"");
}

std::string camera_film(std::span<const std::string> frames, double period_s, const Crop& crop) {
  if (frames.empty()) return {};
  const double turn_s = period_s * static_cast<double>(frames.size());
  // Names that nothing else in a page has: an inline SVG's style holds for all of it.
  std::string content = fmt::format(
      "<style>@keyframes film-turn {{ 0% {{ visibility: visible }} {0:.4f}%, 100% {{ visibility: hidden }} }}\n"
      ".film g.shot {{ visibility: hidden; animation: film-turn {1:.3f}s step-end infinite }}\n"
      "@media print {{ .film g.shot {{ animation: none }} .film g.first {{ visibility: visible }} }}\n"
      "@media (prefers-reduced-motion: reduce) {{ .film g.shot {{ animation: none }} .film g.first {{ visibility: "
      "visible }} }}</style>\n",
      100.0 / static_cast<double>(frames.size()), turn_s);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // A negative delay: every frame is somewhere in the turn from the first moment on.
    const double delay_s = period_s * static_cast<double>(i) - (i == 0 ? 0 : turn_s);
    content += fmt::format("<g class=\"shot{}\" style=\"animation-delay: {:.3f}s\">{}</g>\n", i == 0 ? " first" : "",
                           delay_s, frames[i]);
  }
  return svg_of(content, crop, "class=\"photo film\"");
}

}  // namespace articam::sim
