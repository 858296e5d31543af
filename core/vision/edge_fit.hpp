#pragma once
/// @file  The ellipse of an edge, to a fraction of a pixel, from the grey levels along rays.

#include <cstdint>

#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

enum class Inside : std::uint8_t { darker, lighter };

/// How much of an edge is told: all, or as if light were even and pixels small, for two thirds of the cost.
enum class Reading : std::uint8_t { full, plain };

/// Of an ellipse's centre along the columns of its M: in radii of the normalised plane.
struct Shift {
  std::int64_t a{}, b{};
};

/// What the fit found besides the ellipse.
struct EdgeFit {
  Ellipse ellipse{};
  std::int32_t plain_u_q16{}, plain_v_q16{};  ///< its centre if light is even, px
  Shift light_q24{};                          ///< what the rays say that light moved it by
  std::int64_t plain_variance_q40{};          ///< of each of a and b, squared radii
  std::int64_t light_variance_q40{};          ///< of light_q24, with what neighbours do to it
  std::uint8_t flaws{};                       ///< Flaw bits
  std::uint16_t blur_q8{};                    ///< standard deviation of the edge, px
  std::uint32_t centre_variance_q24{};        ///< of u and of v, px^2, from the scatter of the rays about the ellipse
  std::uint32_t axis_variance_q24{};          ///< of a semi-axis, px^2: the same, and what blur may have left
  std::int32_t contrast_q4{};                 ///< mean step of grey across the edge, Q4, positive
  std::int32_t roughness_q16{};               ///< RMS distance of the edge from the ellipse, in radii, Q16
  std::int32_t corners_q16{};  ///< amplitude of its third and fourth harmonic, which polygons have, in radii
};

/// Moves an ellipse onto the edge near it.
///
/// The plane is normalised so that the ellipse is the unit circle, and the grey levels I_kj are read along rays k from
/// 1 - h to 1 + h radii r_j. Their mean over the rays is the edge's profile P, with the derivative D. Light that falls
/// unevenly brightens a point of ray k by a factor 1 + g_k r_j, g = (cos t, sin t) . a, so that a ray which meets the
/// edge at rho reads
///     I_kj = (1 + g_k r_j) P_j - rho_k D_j;
/// its products with r P and D |D| give both. Rays tell a gain and a shift of the centre apart only by what the window
/// shows beside the edge. So what neighbours show there is taken off, and a light that is no stronger than noise and
/// what neighbours may leave is not believed.
/// The mean of the profile is the size, the first harmonic of rho the centre, the second the shape:
///     rho(t) = s + (cos t, sin t) . c + p cos 2t + q sin 2t,  centre += M c,  M <- M (1 + s + |p q; q -p|).
///
/// Shapes  `reach_q16` is the largest h allowed by what lies inside and around the edge, in radii.
/// Errors  false where there is no edge of that polarity near the seed: the centre stays within half a radius, the
///         size within 30 %; `out` is unchanged then.
/// Work    at most three readings of 16 rays and three of up to 128; one of each where the seed is good.
///         `budget` loses kLooksPerRay for each ray, and for kRaysPerPass more in each reading.
bool fit_edge(const ImageView& image, Inside inside, Reading reading, std::int32_t reach_q16, const Ellipse& seed,
              int& budget, EdgeFit& out) noexcept;

/// How likely light is uneven that seems to shift by p = a^2 + b^2 where noise and neighbours make v of each: the odds
/// are (p / v)^3.  p and v below 2^46, in the same unit.
std::int64_t belief_in_light_q16(std::int64_t p, std::int64_t v) noexcept;

inline constexpr std::int64_t kGrid_q24 = 4;  ///< px^2: what the pixel grid does to centres without any noise
inline constexpr int kLooksPerRay = 18;       ///< what a ray costs, in pixels looked at by the search
inline constexpr int kRaysPerPass = 8;        ///< what a reading costs besides its rays

}  // namespace articam::vision
