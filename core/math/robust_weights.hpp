#pragma once
/// @file  How much a residual is believed.

#include <cmath>

namespace articam::math {

/// Huber's weight of a residual in units of its standard deviation: 1 up to `k`, then k/|r|.
/// With k = 1.345 the estimate keeps 95 % of the efficiency of least squares on Gaussian noise.
/// Source  Huber, "Robust statistics", 1981, section 4.2.
template <class S>
S huber_weight(S residual2, S k = S(1.345)) noexcept {
  return residual2 <= k * k ? S(1) : k / std::sqrt(residual2);
}

/// Huber's loss of the same residual: r^2/2 inside, k |r| - k^2/2 outside.
template <class S>
S huber_loss(S residual2, S k = S(1.345)) noexcept {
  return residual2 <= k * k ? S(0.5) * residual2 : k * std::sqrt(residual2) - S(0.5) * k * k;
}

}  // namespace articam::math
