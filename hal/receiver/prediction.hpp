#pragma once
/// @file  Where the object is now, judged by where it was and how it moved.

#include "hal/wire/message.hpp"

namespace articam::receiver {

/// Moves a valid estimate on by dt at constant velocity:  t += v dt,  R = exp(w dt) R,  joints += rates dt, and the
/// pose in {base} with it. Velocity, covariance and times stay as they were at the capture; joint limits are not known
/// here. False when a result is not finite; the estimate is then untouched.
[[nodiscard]] bool predict(wire::EstimateMessage& estimate, double dt_s) noexcept;

}  // namespace articam::receiver
