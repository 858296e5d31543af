#include "host_sim/world/sway.hpp"

#include <cmath>

#include "host_sim/world/hash.hpp"

namespace articam::sim {
namespace {
constexpr double kTurn = 2 * 3.14159265358979323846;
}

Sway::Sway(const SwayOptions& options, std::uint64_t seed) {
  Dice dice{seed};
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const double rms = axis < 3 ? options.position_m[axis] : options.rotation_rad[axis - 3];
    for (Sine& sine : axes_[axis]) {
      sine.amplitude = rms * std::sqrt(2.0 / kSines);
      sine.rate = kTurn * dice.between(options.low_hz, options.high_hz);
      sine.phase = dice.between(0, kTurn);
    }
  }
}

Sway::Motion Sway::at(double t_s) const noexcept {
  Vec6 value = Vec6::Zero(), rate = Vec6::Zero();
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    for (const Sine& sine : axes_[axis]) {
      const auto turn = math::sin_cos(sine.rate * t_s + sine.phase);
      value[static_cast<Eigen::Index>(axis)] += sine.amplitude * turn.sin;
      rate[static_cast<Eigen::Index>(axis)] += sine.amplitude * sine.rate * turn.cos;
    }
  }
  return {{math::exp_so3<double>(value.tail<3>()), value.head<3>()}, rate};
}

}  // namespace articam::sim
