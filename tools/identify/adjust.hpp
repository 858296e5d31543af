#pragma once
/// @file  A recording -> the constants that explain it best: an adjustment of all moments at once.

#include "tools/identify/arrow.hpp"
#include "tools/identify/constants.hpp"
#include "tools/identify/recording.hpp"

namespace articam::identify {

/// All unknowns: those of the moments, which Moment holds, and the shared ones.
struct Solution {
  Recording moments;
  VectorXd constants;
  MatrixXd information;  ///< about the constants, prior included, all else unknown, for the noise below
  double noise{1};       ///< of the sightings, as a multiple of their own deviations; at least 1
  int num_sightings{}, num_outliers{};
  double rms_px{};
  bool converged{};
};

/// Levenberg and Marquardt's method from `start` on, Huber's loss beyond kHuber deviations. `noise` multiplies the
/// deviations of the sightings; the noise in the result is what the residuals say.
Solution adjust(const Object& object, const CameraParameters& camera, const Constants& constants, const Prior& prior,
                const Solution& start);

/// Solution::information where nothing has been adjusted yet.
MatrixXd information_at(const Object& object, const CameraParameters& camera, const Constants& constants,
                        const Prior& prior, Solution solution);

/// Where an adjustment begins: what the tracker made of each moment, and the medians of the joints that stood still.
Solution begin(const Recording& moments, const Constants& constants);

inline constexpr double kHuber = 3;

}  // namespace articam::identify
