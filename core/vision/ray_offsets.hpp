#pragma once
/// @file  Where each ray meets an edge, and the harmonics of that around the mark.

#include <array>
#include <cstdint>

#include "core/vision/edge_profile.hpp"

namespace articam::vision {

/// Fourier coefficients: x_k = a cos n t_k + b sin n t_k.
struct Harmonic {
  std::int64_t a{}, b{};
};

/// Distances from the mean edge in samples, Q8, freed of the light's gradient.
struct RayOffsets {
  int rays{};
  PerRay rho_q8;
  std::int64_t doubted_q32;  ///< variance of the first harmonic that is left by not knowing how even the light is

  Harmonic harmonic_q16(int n) const noexcept;
  /// Mean square of what is left without the harmonics 0, 1 and 2, Q16, per degree of freedom.
  std::int64_t scatter_q16(const Harmonic& first_q16, const Harmonic& second_q16) const noexcept;
};

/// Rays that do not cross the edge (see find_crossings) are taken to meet it where the ellipse is. `doubt_q16` is the
/// difference of brightness over a radius that is not believed to be the light's.
void find_offsets(const RaySamples& samples, const EdgeProfile& profile, const PerRay& crosses, std::int64_t doubt_q16,
                  RayOffsets& out) noexcept;

}  // namespace articam::vision
