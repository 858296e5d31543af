#include "hal/replay/overlay.hpp"

#include <cairo.h>

#include <memory>
#include <numbers>

namespace articam::hal {
namespace {

constexpr double kScale = 2;
constexpr int kCaption_px = 20;

struct Destroy {
  void operator()(cairo_t* cr) const { cairo_destroy(cr); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;

Surface grey_surface(const ImageView& image) {
  Surface surface{cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width_px, image.height_px)};
  cairo_surface_flush(surface.get());
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int v = 0; v < image.height_px && data != nullptr; ++v) {
    auto* row = reinterpret_cast<std::uint32_t*>(data + v * stride);
    for (int u = 0; u < image.width_px; ++u) row[u] = 0x010101u * image.row(v)[u];
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void outline(cairo_t* cr, const vision::Ellipse& ellipse) {
  using vision::from_q16;
  cairo_matrix_t unit_circle_to_image;
  cairo_matrix_init(&unit_circle_to_image, from_q16(ellipse.m00_q16), from_q16(ellipse.m10_q16), 0,
                    from_q16(ellipse.m11_q16), from_q16(ellipse.u_q16), from_q16(ellipse.v_q16));
  cairo_save(cr);
  cairo_transform(cr, &unit_circle_to_image);
  cairo_new_sub_path(cr);
  cairo_arc(cr, 0, 0, 1, 0, 2 * std::numbers::pi);
  cairo_restore(cr);
  cairo_stroke(cr);
}

void cross(cairo_t* cr, const Overlay::Predicted& mark) {
  if (mark.matched)
    cairo_set_source_rgb(cr, 0.1, 0.9, 0.2);
  else
    cairo_set_source_rgb(cr, 1.0, 0.2, 0.1);
  const double arm = 0.6 * mark.radius_px + 2;
  cairo_move_to(cr, mark.u_px - arm, mark.v_px), cairo_line_to(cr, mark.u_px + arm, mark.v_px);
  cairo_move_to(cr, mark.u_px, mark.v_px - arm), cairo_line_to(cr, mark.u_px, mark.v_px + arm);
  cairo_stroke(cr);
  cairo_move_to(cr, mark.u_px + mark.radius_px + 2, mark.v_px - mark.radius_px - 1);
  cairo_show_text(cr, mark.name.c_str());
}

}  // namespace

Status write_overlay(const std::filesystem::path& path, const ImageView& image, const Overlay& overlay,
                     std::string& why) {
  if (!image.ok()) return why = path.string() + ": there is no frame to draw", Status::bad_argument;
  const Surface frame = grey_surface(image);
  const Surface picture{cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kScale) * image.width_px,
                                                   static_cast<int>(kScale) * image.height_px + kCaption_px)};
  const Context context{cairo_create(picture.get())};
  cairo_t* cr = context.get();
  cairo_save(cr);
  cairo_scale(cr, kScale, kScale);
  cairo_set_source_surface(cr, frame.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
  cairo_paint(cr);
  cairo_translate(cr, 0.5, 0.5);  // a pixel's integer coordinates are its centre
  cairo_set_line_width(cr, 0.6);
  cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, 6);
  cairo_set_source_rgb(cr, 1.0, 0.85, 0.0);
  for (const auto& detection : overlay.seen) outline(cr, detection.outer);
  for (const auto& mark : overlay.predicted) cross(cr, mark);
  cairo_restore(cr);
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_set_font_size(cr, 13);
  cairo_move_to(cr, 6, kScale * image.height_px + 14);
  cairo_show_text(cr, overlay.caption.c_str());

  const cairo_status_t status = cairo_surface_write_to_png(picture.get(), path.c_str());
  if (status == CAIRO_STATUS_SUCCESS) return Status::ok;
  why = path.string() + ": " + cairo_status_to_string(status);
  return Status::io_error;
}

}  // namespace articam::hal
