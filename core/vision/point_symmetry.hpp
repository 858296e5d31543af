#pragma once
/// @file  A ring's centre from all that is seen of it, however blurred.

#include "core/vision/concentric.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

/// Half a turn about its centre leaves a ring's image as it is, blurred or not, but for the little by which perspective
/// parts its circles. In the normalised plane, with r in radii, S the mean of the grey levels I of opposite points,
/// smooth along the turn (harmonics 0, 2 and 4), and o the hole's offset,
///
///     (I(x) - I(-x)) / 2 = -grad S(x) . (c + o (1 - r^2) / (1 - k^2)),
///
/// whose least squares over all points up to 1.1 radii are the move c. Edges that are nearer to each other than they
/// are wide need not be told apart. 13 samples are read from the middle to 1.2 radii, so an edge must not be narrower
/// than they are apart: of others io is unchanged.
/// Holds for even light: io, what both edges tell, keeps the weight that light has by them. Where more is left than
/// noise would leave, something hides in the ring, and the variance grows with it.
///
/// Work  two readings of 32 to 128 rays; `budget` is charged as by fit_edge().
void weigh_symmetry(const ImageView& image, const EdgeFit& outer, std::int32_t ratio_q16, int& budget,
                    Centre& io) noexcept;

}  // namespace articam::vision
