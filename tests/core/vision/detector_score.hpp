#pragma once
/// @file  What a detector found of the markers that were shown.

#include <cmath>
#include <cstddef>
#include <span>

#include "core/vision/detection.hpp"
#include "tests/core/vision/marker_scene.hpp"

namespace articam::test {

/// Sums over marks that were found within a pixel of their true place, and what the rest was.
struct DetectorScore {
  int shown{}, found{}, surplus{};
  double squared_px2{};       ///< distance of the centre, 2-D
  double normalised{};        ///< the same in units of its variance, of one coordinate
  double major_error{};       ///< relative, of the major axis
  double major_normalised{};  ///< squared error of the major semi-axis in units of its variance

  double rms_px() const { return std::sqrt(squared_px2 / found); }
  double normalised_variance() const { return normalised / found; }
  double mean_major_error() const { return major_error / found; }
  double axis_variance() const { return major_normalised / found; }
  double share_found() const { return static_cast<double>(found) / shown; }

  void add(std::span<const sim::SceneMarker> markers, const vision::Detections& marks) {
    int matched = 0;
    for (const sim::SceneMarker& marker : markers) {
      ++shown;
      const TrueEllipse truth = imaged(marker, marker.outer_radius_m);
      for (const vision::Detection& mark : marks) {
        const TrueEllipse seen = measured(mark.outer);
        const double squared = std::pow(seen.u_px - truth.u_px, 2) + std::pow(seen.v_px - truth.v_px, 2);
        if (squared > 1) continue;
        ++matched;
        squared_px2 += squared;
        normalised += squared / 2 / (mark.centre_variance_q24 / 16777216.0);
        major_error += seen.major_px / truth.major_px - 1;
        major_normalised += std::pow(seen.major_px - truth.major_px, 2) / (mark.axis_variance_q24 / 16777216.0);
        break;
      }
    }
    found += matched;
    surplus += static_cast<int>(marks.size()) - matched;
  }
};

}  // namespace articam::test
