#pragma once
/// @file  The ellipse of an edge, to a fraction of a pixel, from the grey levels along rays.

#include <cstdint>

#include "core/vision/detection.hpp"
#include "core/vision/fixed_point.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

enum class Inside : std::uint8_t { darker, lighter };

/// What the fit found besides the ellipse.
struct EdgeFit {
  Ellipse ellipse{};
  std::uint32_t centre_variance_q16{};  ///< of u and of v, px^2, from the scatter of the rays about the ellipse
  std::int32_t contrast_q4{};           ///< mean step of grey across the edge, Q4, positive
  std::int32_t roughness_q16{};         ///< RMS distance of the edge from the ellipse, in radii, Q16
  std::int32_t corners_q16{};           ///< amplitude of its third and fourth harmonic, which polygons have, in radii
};

/// Geometric mean of the semi-axes, px, Q16.
inline std::int64_t mean_radius_q16(const Ellipse& e) noexcept {
  return integer_sqrt(static_cast<std::uint64_t>(std::int64_t{e.m00_q16} * e.m11_q16));
}

/// Moves an ellipse onto the edge near it.
///
/// The plane is normalised so that the ellipse is the unit circle, and the grey levels are read along rays from
/// 1 - h to 1 + h radii. Their mean over the rays is the edge's profile P; its derivative P', freed of what a
/// change of brightness or contrast along the ray would do, is the filter that tells each ray's offset
///     rho_k = - sum_j w_j I_kj / sum_j w_j P'_j,     w = P' less its parts along 1 and P.
/// The mean of the offsets is the size, their first harmonic the centre, the second the shape:
///     rho(t) = s + (cos t, sin t) . c + p cos 2t + q sin 2t,  centre += M c,  M <- M (1 + s + |p q; q -p|).
///
/// Shapes  `reach_q16` is the largest h allowed by what lies inside and around the edge, in radii.
/// Errors  false where there is no edge of that polarity near the seed: the centre stays within half a radius, the
///         size within 30 %; `out` is unchanged then.
bool fit_edge(const ImageView& image, Inside inside, std::int32_t reach_q16, const Ellipse& seed,
              EdgeFit& out) noexcept;

}  // namespace articam::vision
