#pragma once
/// @file  An ellipse in the image plane in floating point: metric (Z = 1) or in pixels.

#include <cmath>
#include <cstdint>

#include "core/math/types.hpp"
#include "core/vision/detection.hpp"

namespace articam::vision {

/// The ellipse { centre + M (cos t, sin t) }, as Ellipse has it: M lower triangular with a positive diagonal, so that
/// every ellipse has one M, a circle nothing special, and all five numbers are lengths.
template <class S>
struct PlaneEllipse {
  Vec<S, 2> centre{Vec<S, 2>::Zero()};
  Mat<S, 2, 2> M{Mat<S, 2, 2>::Zero()};
};

/// The lower triangular M with  M M^T = A A^T, A regular: the same ellipse; 0 of an A whose first row is 0.
template <class S>
Mat<S, 2, 2> lower_triangular(const Mat<S, 2, 2>& A) noexcept {
  const S m00 = std::sqrt(A(0, 0) * A(0, 0) + A(0, 1) * A(0, 1));
  if (!(m00 > S(0))) return Mat<S, 2, 2>::Zero();
  const S area = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  Mat<S, 2, 2> M;
  M << m00, S(0), (A(0, 0) * A(1, 0) + A(0, 1) * A(1, 1)) / m00, (area < S(0) ? -area : area) / m00;
  return M;
}

/// Semi-major axis: the larger singular value of M.
template <class S>
S semi_major(const PlaneEllipse<S>& e) noexcept {
  const S sum = S(0.5) * e.M.squaredNorm(), area = e.M(0, 0) * e.M(1, 1);
  const S gap2 = sum * sum - area * area;
  return std::sqrt(sum + std::sqrt(gap2 > S(0) ? gap2 : S(0)));
}

template <class S>
PlaneEllipse<S> from_q16(const Ellipse& e) noexcept {
  PlaneEllipse<S> ellipse;
  ellipse.centre = {S(from_q16(e.u_q16)), S(from_q16(e.v_q16))};
  ellipse.M << S(from_q16(e.m00_q16)), S(0), S(from_q16(e.m10_q16)), S(from_q16(e.m11_q16));
  return ellipse;
}

/// Rounded to the nearest; a number that is not, or beyond 2^15, is held at that bound.
template <class S>
Ellipse to_q16(const PlaneEllipse<S>& e) noexcept {
  const auto q16 = [](S x) {
    constexpr S kMost = S(32767);
    const S held = x > -kMost ? (x < kMost ? x : kMost) : -kMost;
    return static_cast<std::int32_t>(held * S(65536) + (held < S(0) ? S(-0.5) : S(0.5)));
  };
  return {q16(e.centre.x()), q16(e.centre.y()), q16(e.M(0, 0)), q16(e.M(1, 0)), q16(e.M(1, 1))};
}

}  // namespace articam::vision
