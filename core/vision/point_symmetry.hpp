#pragma once
/// @file  A ring's centre from all that is seen of it, however blurred.

#include "core/vision/concentric.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

/// Half a turn about its centre leaves a ring's image as it is, blurred or not, but for the little by which perspective
/// parts its circles. In the normalised plane, with r in radii, S the mean of the grey levels I of opposite points,
/// smooth along the turn (harmonics 0, 2 and 4), and o the hole's offset,
///
///     (I(x) - I(-x)) / 2 = -grad S(x) . (c + o (1 - r^2) / (1 - k^2)) + S(x) x . g,
///
/// whose least squares over all points are the move c, and what light grows by, g: in even light g is 0 and points up
/// to 1.06 radii count, else up to 1.24, on the mark's border. Both are weighted as io, what the edges tell, believes
/// in light; where light hardly counts or cannot be told, the edges' answer stands for the second. Edges that are
/// nearer to each other than they are wide need not be told apart.
/// io is unchanged where something hides the ring, where its edges are much narrower than the samples' distance, an
/// eleventh of a radius, and where perspective parts its circles by half a pixel.
///
/// Work  two readings of 32 to 128 rays, three in uneven light; `budget` is charged as by fit_edge().
void weigh_symmetry(const ImageView& image, const EdgeFit& outer, std::int32_t ratio_q16, int& budget,
                    Centre& io) noexcept;

}  // namespace articam::vision
