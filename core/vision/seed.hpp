#pragma once
/// @file  A run of pixels that may cross a mark's middle -> the ellipse that chords through it span.

#include <cstdint>

#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

/// Dark, light, dark along a row: columns first .. inner_first - 1, .. inner_end - 1, .. end - 1.
struct RowChord {
  int first, inner_first, inner_end, end;
};

/// The chords that a row cuts from a ring's two edges have one middle, whatever its tilt, and near the centre lengths
/// of the edges' ratio. Called at every dark run's end: three comparisons and no branch.
constexpr bool may_cross_ring(const RowChord& chord, std::int32_t ratio_q8) noexcept {
  const int left = chord.inner_first - chord.first, right = chord.end - chord.inner_end;
  const int hole = chord.inner_end - chord.inner_first, whole = chord.end - chord.first;
  const int lopsided = left > right ? left - right : right - left, expected_q8 = ratio_q8 * whole;
  return (4 * lopsided <= whole + 6) & (256 * (4 * hole + 7) >= 3 * expected_q8) &
         (256 * (4 * hole - 6) <= 5 * expected_q8);
}

/// What a search for marks is limited by.
struct SearchLimits {
  int least_contrast{};  ///< grey levels between light and dark
  int budget{};          ///< pixels that may still be looked at; below 0 it is used up
};

/// The outer ellipse of a ring whose hole row v crosses near its middle.
bool seed_ring(const ImageView& image, const RowChord& row, int v, std::int32_t ratio_q16, SearchLimits& limits,
               Ellipse& outer) noexcept;

/// The edge of a dot that columns first .. end - 1 of row v cross near its middle.
bool seed_dot(const ImageView& image, int first, int end, int v, bool light, SearchLimits& limits,
              Ellipse& edge) noexcept;

}  // namespace articam::vision
