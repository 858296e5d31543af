#pragma once
/// @file  Sizes of paper.

#include <array>
#include <string_view>

namespace articam::markers {

struct Paper {
  std::string_view name;
  double width_mm{}, height_mm{};

  constexpr bool landscape() const { return width_mm > height_mm; }
  constexpr Paper turned() const { return {name, height_mm, width_mm}; }
};

/// Upright, the smaller ones first.
inline constexpr std::array kPapers{Paper{"Letter", 215.9, 279.4}, Paper{"A4", 210, 297}, Paper{"A3", 297, 420}};

/// The ruler (layout.hpp) fits between margins of this width on all of them.
inline constexpr double kMaxMargin_mm = 50;

}  // namespace articam::markers
