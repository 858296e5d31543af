#pragma once
/// @file  The least squares of point_symmetry.hpp.

#include <cstdint>

#include "core/vision/edge_fit.hpp"
#include "core/vision/opposite_points.hpp"

namespace articam::vision {

/// | aa ab; ab bb |, below 2^20.
struct Symmetric2 {
  std::int64_t aa{}, ab{}, bb{};
  std::int64_t trace() const noexcept { return aa + bb; }
  std::int64_t det() const noexcept { return aa * bb - ab * ab; }
  /// det times the inverse times x.
  Shift adjugate_times(const Shift& x) const noexcept { return {bb * x.a - ab * x.b, aa * x.b - ab * x.a}; }
  /// Has an inverse that can be trusted: the trace is 2^14 or more, the one eigenvalue not above 30 times the other.
  bool is_round() const noexcept { return trace() >= 1 << 14 && 32 * det() > square(trace()); }
};

/// W c = right. Sums are weighted by the samples' steps, which is their share of the area.
struct SymmetricFit {
  Symmetric2 W;             ///< of the slopes, grey^2 per step^2, Q6, times 2^-down
  Shift right;              ///< Q22 times 2^-down, so that c is in steps, Q16
  std::int64_t left_q10{};  ///< of (D / 2)^2 beside what the hole's offset, and light if it is sought, explain, grey^2
  int down{};
  int area{};  ///< the weights of a ray's samples

  /// And what is left when c is known, too. False where the slopes do not tell, or cannot be told from light, or c is
  /// beyond a step.
  bool solve(Shift& c_q16, std::int64_t& rest_q10) const noexcept;
};

/// Where circles of radius r lie (1 - r^2) o from the centre, o in steps, Q16, below sixteen. In even light the ring
/// alone counts; how light grows, whichever way, its border tells, too, which must have been read.
SymmetricFit fit_in_even_light(const OppositePoints& points, const Shift& o) noexcept;
/// False where the ring does not tell how light grows.
bool fit_in_any_light(const OppositePoints& points, const Shift& o, SymmetricFit& out) noexcept;

/// How far a change of o changes c in even light, Q16; a mean of both directions.
std::int64_t share_of_offset_q16(const OppositePoints& points) noexcept;

}  // namespace articam::vision
