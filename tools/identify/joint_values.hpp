#pragma once
/// @file  All joint values of a moment.

#include "tools/identify/constants.hpp"
#include "tools/identify/recording.hpp"

namespace articam::identify {

/// Those that stood still from the constants, the others from the moment.
inline VectorXd joint_values(const Moment& moment, const Constants& constants, const VectorXd& x) {
  VectorXd values = VectorXd::Map(moment.joints.data(), static_cast<Eigen::Index>(moment.joints.size()));
  for (int i = 0; i < constants.num_still(); ++i) values[constants.still()[static_cast<std::size_t>(i)]] = x[i];
  return values;
}

}  // namespace articam::identify
