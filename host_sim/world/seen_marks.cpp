#include "host_sim/world/seen_marks.hpp"

#include <algorithm>
#include <cmath>

namespace articam::sim {

EdgeNoise edge_noise(double radius_px, double noise_grey) noexcept {
  constexpr double kGrid_px = 0.0025, kPerGrey = 0.0064, kBias_px2 = 0.25;
  const double centre_px2 = kGrid_px * kGrid_px + kPerGrey * kPerGrey * noise_grey * noise_grey / radius_px;
  const double bias_px = kBias_px2 / radius_px;
  return {centre_px2, 1.5 * centre_px2, 1.5 * centre_px2 + bias_px * bias_px};
}

double normal(Dice& dice) noexcept {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += dice.between(0, 1);
  return sum;
}

vision::Ellipse measured(const vision::PlaneEllipse<double>& edge, const EdgeNoise& noise, Dice& dice) noexcept {
  const double centre_px = std::sqrt(noise.centre_px2), axis_px = std::sqrt(noise.axis_px2);
  vision::PlaneEllipse<double> seen = edge;
  for (double& x : seen.centre) x += centre_px * normal(dice);
  seen.M(0, 0) += axis_px * normal(dice);
  seen.M(1, 0) += axis_px * normal(dice);
  seen.M(1, 1) += axis_px * normal(dice);
  return vision::to_q16(seen);
}

std::uint32_t variance_q24(double variance_px2) noexcept {
  return static_cast<std::uint32_t>(std::clamp(variance_px2 * 16777216.0, 1.0, 4294967295.0));
}

}  // namespace articam::sim
