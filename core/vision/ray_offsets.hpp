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

/// Distances from the mean edge in samples, Q8, and what uneven light may have done to them: light that grows by `gain`
/// a radius moves each ray's edge as a shift of the centre by `gain` times `per_gain` does.
struct RayOffsets {
  int rays;
  PerRay rho_q8;
  Harmonic seen_q16;          ///< the first harmonic of rho
  Harmonic light_q16;         ///< the shift by the light that the rays show, samples
  Harmonic beside_q16;        ///< and by what their last sample alone shows beside that: neighbours, mostly
  std::int64_t per_gain_q16;  ///< samples
  std::int64_t shared_q16;    ///< squared correlation of a shift and a gain, below 1: how far rays tell them apart

  Harmonic harmonic_q16(int n) const noexcept;
  /// Mean square of what is left without the harmonics 0, 1 and 2, Q16, per degree of freedom.
  std::int64_t scatter_q16(const Harmonic& first_q16, const Harmonic& second_q16) const noexcept;
};

/// Of rays read in a window of +-h radii. Those that do not cross the edge (see find_crossings) are taken to meet it
/// where the ellipse is. find_light() fills in the rest, light and neighbours.
void find_offsets(const RaySamples& samples, const EdgeProfile& profile, const PerRay& crosses,
                  RayOffsets& out) noexcept;
void find_light(const RaySamples& samples, const EdgeProfile& profile, std::int32_t half_window_q16,
                RayOffsets& out) noexcept;

/// Takes off what reading between pixels does. A sample that lies f of a pixel beyond one has, blended from both, half
/// f (1 - f) times the second derivative in it, which moves the edge by where on the grid it lies: by hundredths of a
/// pixel where it runs along the grid, and there many rays see the same.
void take_off_blending(const RaySamples& samples, const EdgeProfile& profile, const PerRay& crosses, const Ellipse& e,
                       std::int64_t minor_q16, std::int32_t half_window_q16, RayOffsets& io) noexcept;

}  // namespace articam::vision
