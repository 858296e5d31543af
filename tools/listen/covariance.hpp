#pragma once
/// @file  The covariance of an estimate, out of the upper triangle that is sent.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "hal/wire/message.hpp"

namespace articam::listen {

inline std::size_t dof(const wire::EstimateMessage& estimate) { return estimate.velocity.size(); }

/// Of degrees of freedom i and k, ordered (t, rotation in {cam}, joints). Only of a valid estimate.
inline double covariance(const wire::EstimateMessage& estimate, std::size_t i, std::size_t k) {
  const auto [row, column] = std::minmax(i, k);
  return estimate.covariance[row * dof(estimate) - row * (row + 1) / 2 + column];
}

inline double deviation(const wire::EstimateMessage& estimate, std::size_t i) {
  return std::sqrt(covariance(estimate, i, i));
}

}  // namespace articam::listen
