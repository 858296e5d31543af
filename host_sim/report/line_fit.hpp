#pragma once
/// @file  A straight line through measurements whose errors are neither equal nor independent.

#include <span>

namespace articam::sim {

/// A value and its 95 % confidence interval.
struct Interval {
  double value{}, low{}, high{};
};

struct LineFit {
  double intercept{};
  double slope{};
  double slope_std{};

  Interval slope_interval() const noexcept { return {slope, slope - 1.96 * slope_std, slope + 1.96 * slope_std}; }
};

/// Ordinary least squares y = intercept + slope x. The slope's standard deviation holds for errors whose size
/// varies and which are correlated over up to `reach` samples (Bartlett weights).
/// Shapes  as many x as y, in the order of time. All zero where there are fewer than 3, or where x does not vary.
/// Source  Newey & West, "A simple, positive semi-definite, heteroskedasticity and autocorrelation consistent
///         covariance matrix", Econometrica 55(3), 1987.
LineFit fit_line(std::span<const double> x, std::span<const double> y, std::size_t reach) noexcept;

}  // namespace articam::sim
