#include "hal/replay/overlay.hpp"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace articam::hal {
namespace {

constexpr int kCaption_px = 22;
constexpr double kLine_px = 1.2, kText_px = 11;  // of the picture, whatever the scale

struct Destroy {
  void operator()(cairo_t* cr) const { cairo_destroy(cr); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;

struct Colour {
  double r, g, b;
};
constexpr Colour kMatched{0.2, 1.0, 0.3}, kUnmatched{1.0, 0.3, 0.2}, kWhite{1, 1, 1};

constexpr Colour colour_of(vision::MarkKind kind) {
  if (kind == vision::MarkKind::ring) return {1.0, 0.85, 0.0};
  return kind == vision::MarkKind::dot_light_on_dark ? Colour{0.1, 0.6, 1.0} : Colour{1.0, 0.3, 1.0};
}

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

/// Draws in the coordinates of the frame, with lines and letters in those of the picture.
class Pen {
 public:
  Pen(cairo_t* cr, double scale) : cr_{cr}, scale_{scale} {
    cairo_set_line_width(cr, kLine_px / scale);
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, kText_px / scale);
  }

  void colour(const Colour& c) const { cairo_set_source_rgb(cr_, c.r, c.g, c.b); }

  void ellipse(const vision::Ellipse& e, bool dashed = false) const {
    using vision::from_q16;
    cairo_matrix_t from_unit_circle;
    cairo_matrix_init(&from_unit_circle, from_q16(e.m00_q16), from_q16(e.m10_q16), 0, from_q16(e.m11_q16),
                      from_q16(e.u_q16), from_q16(e.v_q16));
    cairo_save(cr_);
    cairo_transform(cr_, &from_unit_circle);
    cairo_new_sub_path(cr_);
    cairo_arc(cr_, 0, 0, 1, 0, 2 * std::numbers::pi);
    cairo_restore(cr_);
    const double dash = 5 / scale_;
    cairo_set_dash(cr_, &dash, dashed ? 1 : 0, 0);
    cairo_stroke(cr_);
    cairo_set_dash(cr_, nullptr, 0, 0);
  }

  void cross(const vision::Ellipse& e, double arm) const {
    const double u = vision::from_q16(e.u_q16), v = vision::from_q16(e.v_q16);
    cairo_move_to(cr_, u - arm / scale_, v), cairo_line_to(cr_, u + arm / scale_, v);
    cairo_move_to(cr_, u, v - arm / scale_), cairo_line_to(cr_, u, v + arm / scale_);
    cairo_stroke(cr_);
  }

  /// Right of an ellipse: what is predicted above, what was seen below, so that both can be read.
  void beside(const vision::Ellipse& e, const std::string& text, double lines) const {
    cairo_move_to(cr_, vision::from_q16(e.u_q16) + vision::from_q16(e.m00_q16) + 4 / scale_,
                  vision::from_q16(e.v_q16) + lines * kText_px / scale_);
    cairo_text_path(cr_, text.c_str());
    cairo_path_t* const letters = cairo_copy_path(cr_);
    cairo_save(cr_);
    cairo_set_source_rgba(cr_, 0, 0, 0, 0.7);  // an edge around them, so that they can be read on any frame
    cairo_set_line_width(cr_, 2.5 / scale_);
    cairo_stroke(cr_);
    cairo_restore(cr_);
    cairo_append_path(cr_, letters);
    cairo_path_destroy(letters);
    cairo_fill(cr_);
  }

 private:
  cairo_t* cr_;
  double scale_;
};

void draw(const Pen& pen, const Overlay& overlay) {
  for (const auto& feature : overlay.predicted) {
    pen.colour(feature.matched ? kMatched : kUnmatched);
    pen.ellipse(feature.outline, true);
    pen.beside(feature.outline, feature.matched ? feature.name : feature.name + ": " + feature.why_not, -0.2);
  }
  for (const auto& [mark, note] : overlay.seen) {
    pen.colour(colour_of(mark.kind));
    pen.ellipse(mark.outer);
    if (mark.kind == vision::MarkKind::ring) pen.ellipse(mark.inner);
    pen.cross(mark.outer, 3);
    const std::string flaws = names_of_flaws(mark.flaws);
    pen.beside(mark.outer, flaws.empty() || note.empty() ? flaws + note : flaws + ", " + note, 0.9);
  }
}

Status write_png(cairo_surface_t* picture, const std::filesystem::path& path, std::string& why) {
  const std::filesystem::path part = path.string() + ".partial";
  std::error_code error;
  const cairo_status_t status = cairo_surface_write_to_png(picture, part.c_str());
  if (status != CAIRO_STATUS_SUCCESS) {
    why = path.string() + ": " + cairo_status_to_string(status);
  } else {
    std::filesystem::rename(part, path, error);
    if (!error) return Status::ok;
    why = path.string() + ": " + error.message();
  }
  std::filesystem::remove(part, error);
  return Status::io_error;
}

}  // namespace

std::string names_of_flaws(unsigned flaws) {
  std::string names;
  constexpr std::array<std::pair<unsigned, const char*>, 4> kNames{{{vision::kBlurred, "blurred"},
                                                                    {vision::kSaturated, "saturated"},
                                                                    {vision::kClipped, "clipped"},
                                                                    {vision::kOccluded, "occluded"}}};
  for (const auto& [flaw, name] : kNames) {
    if ((flaws & flaw) == 0) continue;
    if (!names.empty()) names += ' ';
    names += name;
  }
  return names;
}

Status write_overlay(const std::filesystem::path& path, const ImageView& image, const Overlay& overlay,
                     std::string& why) {
  if (!image.ok()) return why = path.string() + ": there is no frame to draw", Status::bad_argument;
  constexpr int kWide_px = 1600, kLargest = 4;
  const int scale = std::clamp(kWide_px / image.width_px, 1, kLargest);
  const Surface frame = grey_surface(image);
  const Surface picture{
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, scale * image.width_px, scale * image.height_px + kCaption_px)};
  const Context context{cairo_create(picture.get())};
  cairo_t* cr = context.get();
  cairo_save(cr);
  cairo_scale(cr, scale, scale);
  cairo_set_source_surface(cr, frame.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
  cairo_paint(cr);
  cairo_translate(cr, 0.5, 0.5);  // a pixel's integer coordinates are its centre
  draw(Pen{cr, static_cast<double>(scale)}, overlay);
  cairo_restore(cr);
  Pen{cr, 1}.colour(kWhite);
  cairo_move_to(cr, 6, scale * image.height_px + 15);
  cairo_show_text(cr, overlay.caption.c_str());
  return write_png(picture.get(), path, why);
}

}  // namespace articam::hal
