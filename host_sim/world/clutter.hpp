#pragma once
/// @file  What else a camera sees: paper, print, and shapes that are nearly markers.

#include <cstdint>

#include "host_sim/world/grey_plane.hpp"

namespace articam::sim {

/// Paints a seeded still life over the whole plane: texture, sheets with lines of print, bars, discs, and plain annuli
/// whose inner : outer ratio stays away from that of the rings. Edges are soft over one pixel.
void paint_clutter(std::uint64_t seed, GreyPlane& plane);

}  // namespace articam::sim
