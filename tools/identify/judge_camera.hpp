#pragma once
/// @file  What an adjustment says of the camera's calibration.

#include "tools/identify/identify.hpp"

namespace articam::identify {

/// @param outermost_px  the sighting farthest from the principal point.
/// @param covariance    of the constants.
std::vector<Judgement> judge_camera(const CameraParameters& camera, const Constants& constants, const VectorXd& x,
                                    const MatrixXd& covariance, const Vec<double, 2>& outermost_px);

}  // namespace articam::identify
