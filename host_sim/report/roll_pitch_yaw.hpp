#pragma once
/// @file  The angles of the paper's figure 5, and how well they are known.

#include "core/math/types.hpp"

namespace articam::sim {

/// R = Rz(yaw) Ry(pitch) Rx(roll), rad, ordered (roll, pitch, yaw). Pitch within a quarter turn.
Vec<double, 3> roll_pitch_yaw(const Quat<double>& R) noexcept;

/// Their standard deviations where the rotation is exp(delta) R and delta has covariance P. Not a number where the
/// camera's z axis is level with the object's x axis: there roll and yaw turn the same way.
Vec<double, 3> roll_pitch_yaw_std(const Quat<double>& R, const Mat<double, 3, 3>& P) noexcept;

}  // namespace articam::sim
