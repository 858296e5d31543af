#pragma once
/// @file  The marks that the front end and its peers are timed on.

#include <numbers>
#include <random>
#include <vector>

#include "tests/core/vision/marker_scene.hpp"

namespace articam::bench {

inline constexpr double kDiameter_px = 37;

/// Of 37 px across when untilted, tilted by 30 deg, in a grid of 5x4, or of 3x2 up to six.
inline std::vector<sim::SceneMarker> marks(int count, model::MarkerKind kind) {
  std::mt19937 random(4);
  const int columns = count > 6 ? 5 : 3, rows = count > 6 ? 4 : 2;
  auto markers = test::grid_of_markers(kind, columns, rows, kDiameter_px, std::numbers::pi / 6, random);
  markers.resize(static_cast<std::size_t>(count));
  return markers;
}

inline std::vector<sim::SceneMarker> rings(int count) { return marks(count, model::MarkerKind::ring); }

}  // namespace articam::bench
