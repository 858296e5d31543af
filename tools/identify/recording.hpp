#pragma once
/// @file  What a recording says: in each moment, where the markers were seen.

#include <cstddef>
#include <vector>

#include "core/math/se3.hpp"

namespace articam::identify {

struct Sighting {
  std::size_t marker{};   ///< row of the object's markers
  Vec<double, 2> pixel;   ///< measured centre of its imaged ellipse
  double variance_px2{};  ///< of each coordinate, new in every moment
  double bias_px2{};      ///< of what is the same again wherever the mark is seen in the same place
};

/// A frame with an estimate. Joint values in the order of q, rad or m.
struct Moment {
  Pose<double> T_cam_obj;
  std::vector<double> joints, joint_deviations;
  std::vector<Sighting> sightings;
};

using Recording = std::vector<Moment>;

/// At most so many moments, evenly along the way that the marks went in the image and along time: a recording that
/// rests most of the time is known by its motion, too.
Recording spread_out(const Recording& recording, std::size_t most);

/// Adds to each variance what repetition cannot take away: so many times the bias as the marker is seen within the same
/// half pixel. A camera on a tripod sees one thing a thousand times.
void mind_repetition(Recording& recording);

/// The joint values that stood still: nine tenths of them within 3.3 of their own deviations, and what a calibration
/// that is a little wrong lets a constant wander: 1 mm of a slide, 0.5 degrees of a turn.
std::vector<int> find_still(const Recording& recording, const std::vector<bool>& slides);

}  // namespace articam::identify
