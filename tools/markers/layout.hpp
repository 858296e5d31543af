#pragma once
/// @file  Marks -> their places on pages. Lengths in mm; (0, 0) is the page's top left corner, x right, y down.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/markers/mark.hpp"
#include "tools/markers/paper.hpp"

namespace articam::markers {

struct Box {
  double x_mm{}, y_mm{}, width_mm{}, height_mm{};

  constexpr double right_mm() const { return x_mm + width_mm; }
  constexpr double bottom_mm() const { return y_mm + height_mm; }
};

/// A mark in its place.
struct Piece {
  Mark mark;
  double x_mm{}, y_mm{};  ///< its centre

  Box square() const;  ///< what is cut out
  Box label() const;
  Box box() const;  ///< all of it: square, crop marks, label
};

using Page = std::vector<Piece>;

inline constexpr double kRuler_mm = 100;  ///< long

struct Sheets {
  Paper paper;  ///< as it lies
  double margin_mm{};
  std::vector<Page> pages;

  Box printable() const;  ///< within the margins
  Box header() const;     ///< its upper part: a line that names the sheet
  Box content() const;    ///< its middle: the pieces
  Box footer() const;     ///< its lower part: instructions, and the ruler
  Box ruler() const;      ///< its scale, as high as the lines at whole cm; the numbers are below
};

/// Places every mark once, on as few pages as shelves allow: larger marks first, since a shelf is as high as its first
/// one, equal ones in the order of the model. Each stands on the first shelf with room. Landscape where that takes
/// fewer pages.
/// Errors  nothing when a mark fits neither way; see objections().
std::optional<Sheets> lay_out(std::span<const Mark> marks, const Paper& paper, double margin_mm);

/// For each mark that does not fit, what it needs and the paper that would do.
std::vector<std::string> objections(std::span<const Mark> marks, const Paper& paper, double margin_mm);

}  // namespace articam::markers
