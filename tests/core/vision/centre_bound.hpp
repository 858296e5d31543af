#pragma once
/// @file  The Cramer-Rao bound of a ring's centre: what no unbiased estimate from one frame's grey levels falls below.

#include "host_sim/world/renderer.hpp"

namespace articam::test {

/// Bounds of the distance of the outer edge's centre from its true place, u and v together, RMS, px.
struct CentreBound {
  double pose_px;   ///< of who knows camera, print and card: only the ring's pose is sought
  double edges_px;  ///< of who seeks three ellipses, the ring's edges and its card's, that need not belong together
};

/// Of a ring on its card before an even wall, as sim::Renderer shows them to test::kVga. Both seek besides: the blur,
/// the light of wall, card and mark, and by how much light grows from side to side and from top to bottom.
CentreBound centre_bound(const sim::SceneMarker& ring, const sim::RenderOptions& options);

}  // namespace articam::test
