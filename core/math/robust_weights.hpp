#pragma once
/// @file  How much a residual is believed.
///
/// Huber's loss of a residual r in units of its standard deviation is r^2/2 up to `k`, and grows as |r| beyond:
///
///     k |r| - k^2/2  =  r^2/2 - (|r| - k)^2/2,    weight k / |r|
///
/// k = 1.345 keeps 95 % of the efficiency of least squares on Gaussian residuals; larger k more, and less robustness.
/// Source  Huber, "Robust statistics", 1981, section 4.2.

namespace articam::math {

/// What twice the loss lacks of the square of a residual of this size, which is beyond k.
template <class S>
constexpr S huber_excess(S size, S k) noexcept {
  return (size - k) * (size - k);
}

/// The weight of a residual of this size, which is beyond k; `full` is that of one within.
template <class S>
constexpr S huber_weight(S size, S k, S full = S(1)) noexcept {
  return full * k / size;
}

}  // namespace articam::math
