#pragma once
/// @file  Measures and small changes of an ellipse in integers.

#include <cstdint>

#include "core/vision/detection.hpp"

namespace articam::vision {

/// Geometric mean of the semi-axes, px, Q16.
std::int64_t mean_radius_q16(const Ellipse& e) noexcept;

/// Mean of the squared semi-axes, px^2, Q16.
std::int64_t mean_square_q16(const Ellipse& e) noexcept;

/// Square of the semi-major axis, px^2, Q16.
std::int64_t major_square_q16(const Ellipse& e) noexcept;

/// Semi-minor axis, px, Q16.
std::int64_t minor_q16(const Ellipse& e) noexcept;

/// Mean variance of u and v, px^2, where each coordinate of the normalised plane has `variance_q40`, squared radii.
std::int64_t in_px_q24(const Ellipse& e, std::int64_t variance_q40) noexcept;

/// Held within what Detection can say.
std::uint32_t to_variance_q24(std::int64_t variance_q24) noexcept;

/// Axes times `factor_q16`, same centre.
Ellipse scaled(Ellipse e, std::int64_t factor_q16) noexcept;

/// M <- lower triangular factor of M (1 + S), S = |s00 s10; s10 s11| small, Q16.
/// False, and unchanged, where it leaves the sizes of marks: half an axis from 1 px to two frames.
bool deform(Ellipse& e, std::int64_t s00_q16, std::int64_t s10_q16, std::int64_t s11_q16) noexcept;

/// Undoes what a blur does to the size. `width_q16`: variance of the edge in squared radii.
bool undo_blur(Ellipse& e, std::int64_t width_q16) noexcept;

}  // namespace articam::vision
