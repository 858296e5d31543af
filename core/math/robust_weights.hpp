#pragma once
/// @file  How much a residual is believed.

#include <cmath>

namespace articam::math {

/// Huber's weight of a residual in units of its standard deviation: 1 up to `k`, then k/|r|.
/// k = 1.345 keeps 95 % of the efficiency of least squares on Gaussian residuals; larger k more, and less robustness.
/// Source  Huber, "Robust statistics", 1981, section 4.2.
template <class S>
S huber_weight(S residual2, S k) noexcept {
  return residual2 <= k * k ? S(1) : k / std::sqrt(residual2);
}

/// Huber's loss of the same residual: r^2/2 inside, k |r| - k^2/2 outside.
template <class S>
S huber_loss(S residual2, S k) noexcept {
  return residual2 <= k * k ? S(0.5) * residual2 : k * std::sqrt(residual2) - S(0.5) * k * k;
}

}  // namespace articam::math
