#include "tools/markers/draw_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace articam::markers {
namespace {

constexpr double kHairline_mm = 0.15;
constexpr double kTolerance_pt = 0.003;  // 1 um: cairo's own, for screens, draws a ring of 10 cm 0.01 mm too large

enum class Weight { normal, bold };
enum class Side { left, centre, right };

/// Letters as their designer drew them: hints are for a screen's pixels, which paper does not have.
void set_font_options(cairo_t* cairo) {
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
}

/// One line of text on the baseline `y_mm`, no wider than the box: it shrinks where it must, and is never cut off.
void write(cairo_t* cairo, const std::string& text, const Box& box, double y_mm, double size_mm, Side side,
           Weight weight = Weight::normal) {
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         weight == Weight::bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size_mm);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  const double shrink = std::min(1.0, box.width_mm / std::max(extents.x_advance, 1e-3));
  const double free_mm = box.width_mm - shrink * extents.x_advance;
  cairo_set_font_size(cairo, shrink * size_mm);
  cairo_move_to(cairo, box.x_mm + (side == Side::left ? 0 : side == Side::right ? free_mm : free_mm / 2), y_mm);
  cairo_show_text(cairo, text.c_str());
}

void line(cairo_t* cairo, double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
  cairo_move_to(cairo, x0_mm, y0_mm);
  cairo_line_to(cairo, x1_mm, y1_mm);
}

void circle(cairo_t* cairo, const Piece& piece, double diameter_mm) {
  cairo_new_sub_path(cairo);
  cairo_arc(cairo, piece.x_mm, piece.y_mm, diameter_mm / 2, 0, 2 * std::numbers::pi);
  cairo_close_path(cairo);
}

/// Even-odd filling leaves a ring's hole and a light dot as bare paper.
void draw_mark(cairo_t* cairo, const Piece& piece) {
  const Mark& mark = piece.mark;
  if (mark.kind == model::MarkerKind::dot_light_on_dark) {
    const Box square = piece.square();
    cairo_rectangle(cairo, square.x_mm, square.y_mm, square.width_mm, square.height_mm);
  }
  circle(cairo, piece, mark.outer_mm);
  if (mark.kind == model::MarkerKind::ring) circle(cairo, piece, mark.inner_mm);
  cairo_fill(cairo);
}

/// From the middle of each side inwards: threads held across them meet in the centre.
void draw_ticks(cairo_t* cairo, const Piece& piece) {
  const double out = square_mm(piece.mark) / 2, in = out - kTick_mm;
  for (const double sign : {-1.0, 1.0}) {
    line(cairo, piece.x_mm + sign * in, piece.y_mm, piece.x_mm + sign * out, piece.y_mm);
    line(cairo, piece.x_mm, piece.y_mm + sign * in, piece.x_mm, piece.y_mm + sign * out);
  }
  if (piece.mark.kind == model::MarkerKind::dot_light_on_dark) cairo_set_source_rgb(cairo, 1, 1, 1);
  cairo_stroke(cairo);
  cairo_set_source_rgb(cairo, 0, 0, 0);
}

/// Outside the corners: nothing of them stays on the piece.
void draw_crop_marks(cairo_t* cairo, const Piece& piece) {
  constexpr double kGap_mm = 1;
  const double corner = square_mm(piece.mark) / 2, near = corner + kGap_mm, far = corner + kCropZone_mm;
  for (const double right : {-1.0, 1.0}) {
    for (const double down : {-1.0, 1.0}) {
      const double x = piece.x_mm + right * corner, y = piece.y_mm + down * corner;
      line(cairo, piece.x_mm + right * near, y, piece.x_mm + right * far, y);
      line(cairo, x, piece.y_mm + down * near, x, piece.y_mm + down * far);
    }
  }
  cairo_stroke(cairo);
}

/// To 0.01 mm, without zeros at the end.
std::string in_mm(double length_mm) {
  std::string text = fmt::format("{:.2f}", length_mm);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string sizes(const Mark& mark) {
  const std::string outer = in_mm(mark.outer_mm);
  switch (mark.kind) {
    case model::MarkerKind::ring:
      return fmt::format("ring {} mm, hole {} mm", outer, in_mm(mark.inner_mm));
    case model::MarkerKind::dot_light_on_dark:
      return fmt::format("light dot {} mm", outer);
    case model::MarkerKind::dot_dark_on_light:
      return fmt::format("dark dot {} mm", outer);
    case model::MarkerKind::point:
      break;
  }
  return {};
}

void draw_label(cairo_t* cairo, const Piece& piece, const std::string& title) {
  const Box label = piece.label();
  write(cairo, piece.mark.name, label, label.y_mm + 2.6, 3, Side::centre, Weight::bold);
  write(cairo, fmt::format("{}, square {} mm", sizes(piece.mark), in_mm(square_mm(piece.mark))), label,
        label.y_mm + 5.8, 2.3, Side::centre);
  write(cairo, title, label, label.y_mm + 8.6, 2.3, Side::centre);
}

void draw_ruler(cairo_t* cairo, const Box& ruler) {
  const double left_mm = ruler.x_mm, foot_mm = ruler.bottom_mm();
  line(cairo, left_mm, foot_mm, ruler.right_mm(), foot_mm);
  constexpr int kLength = static_cast<int>(kRuler_mm);
  for (int mm = 0; mm <= kLength; ++mm) {
    const double height_mm = ruler.height_mm * (mm % 10 == 0 ? 1 : mm % 5 == 0 ? 0.7 : 0.4);
    line(cairo, left_mm + mm, foot_mm, left_mm + mm, foot_mm - height_mm);
  }
  cairo_stroke(cairo);
  for (int mm = 0; mm <= kLength; mm += 10) {
    constexpr double kWidth_mm = 9;
    const std::string number = fmt::format("{}{}", mm, mm == kLength ? " mm" : "");
    write(cairo, number, {left_mm + mm - kWidth_mm / 2, 0, kWidth_mm, 0}, foot_mm + 3, 2.3, Side::centre);
  }
}

void draw_advice(cairo_t* cairo, const Box& footer) {
  constexpr const char* kAdvice[] = {
      "Print at 100 % (actual size), not \"fit to page\". "
      "Then measure the ruler, and a square from crop mark to crop mark in both directions.",
      "Wrong by more than 0.2 mm? Print again, or put the diameters that you measure into the markers file: "
      "1 % in size is 1 % in distance.",
      "Cut from crop mark to crop mark and write the name on the back. "
      "The ticks point to the centre, the origin of the link; turned or not, a marker is the same."};
  double y_mm = footer.y_mm + 3.5;
  for (const char* advice : kAdvice) {
    write(cairo, advice, footer, y_mm, 2.6, Side::left);
    y_mm += 4;
  }
}

}  // namespace

void draw_page(cairo_t* cairo, const Sheets& sheets, std::size_t i_page, const std::string& title) {
  cairo_set_source_rgb(cairo, 1, 1, 1);  // a viewer may put an SVG on any ground
  cairo_paint(cairo);
  cairo_set_source_rgb(cairo, 0, 0, 0);
  cairo_set_line_width(cairo, kHairline_mm);
  cairo_set_tolerance(cairo, kTolerance_pt);
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  set_font_options(cairo);

  const Box header = sheets.header();
  write(cairo, "Markers of " + title, header, header.y_mm + 4, 4, Side::left, Weight::bold);
  const std::string where = fmt::format("page {} of {}, {} {}", i_page + 1, sheets.pages.size(), sheets.paper.name,
                                        sheets.paper.landscape() ? "landscape" : "portrait");
  write(cairo, where, header, header.y_mm + 4, 3, Side::right);
  for (const Piece& piece : sheets.pages[i_page]) {
    draw_mark(cairo, piece);
    draw_ticks(cairo, piece);
    draw_crop_marks(cairo, piece);
    draw_label(cairo, piece, title);
  }
  draw_advice(cairo, sheets.footer());
  draw_ruler(cairo, sheets.ruler());
}

}  // namespace articam::markers
