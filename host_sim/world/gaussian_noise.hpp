#pragma once
/// @file  The noise of a sensor, and its rounding to 8 bits.

#include <array>
#include <cstdint>
#include <vector>

#include "host_sim/world/grey_plane.hpp"

namespace articam::sim {

/// Independent Gaussian noise in every pixel, a function of (seed, frame, pixel) alone: a frame is the same
/// whether or not others were made before it.
class GaussianNoise {
 public:
  /// sigma_grey: standard deviation in grey levels, 0 to 100.
  GaussianNoise(double sigma_grey, std::uint64_t seed);

  /// Adds the noise of one frame to `clean`, rounds, and clamps to 0..255.
  void digitise(const GreyPlane& clean, std::uint64_t frame_index, std::vector<std::uint8_t>& pixels) const;

 private:
  /// Equally likely values: the quantiles (i + 1/2) / 4096 of the normal law, so the tails end at 3.67 sigma.
  static constexpr std::size_t kQuantiles = 4096;
  std::array<std::int16_t, kQuantiles> noise_q6_{};
  std::uint64_t seed_;
};

}  // namespace articam::sim
