#pragma once
/// @file  How a standing humanoid moves without wanting to.

#include <array>
#include <cstdint>

#include "core/math/se3.hpp"
#include "host_sim/dynamics/mechanism.hpp"

namespace articam::sim {

/// Root mean squares over time, of each axis.
struct SwayOptions {
  std::array<double, 3> position_m{0.0015, 0.001, 0.0003};   ///< forwards, sideways, up
  std::array<double, 3> rotation_rad{0.001, 0.0015, 0.001};  ///< about the same axes: a tenth of a degree
  double low_hz = 0.05, high_hz = 0.5;
};

/// A pose that wanders about none: on each axis a sum of sines, at frequencies and phases drawn from the band.
class Sway {
 public:
  Sway(const SwayOptions& options, std::uint64_t seed);

  struct Motion {
    Pose<double> pose;
    Vec6 twist;  ///< (velocity of the origin, angular velocity), in the frame that sways about
  };
  /// By first order in the angles, which are small.
  Motion at(double t_s) const noexcept;

 private:
  static constexpr int kSines = 5;
  struct Sine {
    double amplitude, rate, phase;  ///< m or rad, rad/s, rad
  };
  std::array<std::array<Sine, kSines>, 6> axes_;
};

}  // namespace articam::sim
