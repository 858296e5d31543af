#pragma once
/// @file  What both edges of a ring tell together of its centre, and of the light.

#include <cstdint>

#include "core/vision/edge_fit.hpp"
#include "core/vision/hole_offset.hpp"

namespace articam::vision {

/// Centre of a ring's outer edge, and what goes with it.
struct Centre {
  std::int32_t u_q16{}, v_q16{};     ///< px
  std::uint32_t variance_q24{};      ///< of u and of v, px^2
  bool edges_agree{};                ///< what follows is known
  std::int64_t uneven_q16{};         ///< how far light is believed to be uneven, 0 to 1
  Shift hole_q24{};                  ///< the hole's offset from it, as perspective makes it, in radii of the ring
  std::int64_t hole_variance_q40{};  ///< of that, a and b together, squared radii
};

/// Light that falls unevenly moves a dark disc's edge one way and a light one's the other. In radii of the outer edge,
/// with x what light moves it by, k the ratio and o the offset of hole_offset(), its two fits see
///
///     0 = c - x,    d = c + o + k x,    l = x,
///
/// 0 where the outer edge is seen if light is even, d the hole's place by that, l what the outer edge's rays show of
/// light. c and x are their least squares; with even light x is 0, and l l^T tells how likely that is. Which of the
/// two solutions o has is weighted, too. The hole's place is known less than the ring's, by its shorter edge and its
/// contrast, or as its own rays scatter.
/// Where what is seen contradicts this by more than four standard deviations, something hides or mirrors in the ring,
/// or it moved: then c is the outer edge's alone, and what contradicts is added to its variance.
///
/// Errors  false where that is more than a tenth of the radius: the edges do not belong together.
bool join_centres(const EdgeFit& outer, const EdgeFit& hole, const Pinhole& camera, std::int32_t ratio_q16,
                  Centre& out) noexcept;

}  // namespace articam::vision
