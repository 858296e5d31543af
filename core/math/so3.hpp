#pragma once
/// @file  Rotations: exponential, logarithm, and the cross-product matrix.
///
/// A rotation vector phi (rad) stands for the rotation by |phi| about phi/|phi|. Perturbations are
/// written on the left, in the outer frame: R = exp(delta) R_0.

#include <cmath>
#include <limits>

#include "core/math/trigonometry.hpp"
#include "core/math/types.hpp"

namespace articam::math {

/// [v]x, so that [v]x p = v x p.   v 3x1, result 3x3.
template <class S>
Mat<S, 3, 3> hat(const Vec<S, 3>& v) noexcept {
  Mat<S, 3, 3> m;
  m << S(0), -v.z(), v.y(), v.z(), S(0), -v.x(), -v.y(), v.x(), S(0);
  return m;
}

/// sin(r) / 2r and cos r of half an angle r, r^2 given.
template <class S>
struct HalfTurn {
  S scale, w;
};
/// Of its own, so that the small turns of a solver's steps can be forced into their caller.
template <class S>
[[gnu::noinline]] HalfTurn<S> large_half_turn(S r2) noexcept {
  const S r = std::sqrt(r2);
  const auto half = sin_cos(r);
  return {S(0.5) * half.sin / r, half.cos};
}

/// Rotation vector (rad) -> unit quaternion.
template <class S>
[[gnu::always_inline]] inline Quat<S> exp_so3(const Vec<S, 3>& phi) noexcept {
  using T = detail::Trigonometry<S>;
  const S r2 = S(0.25) * (phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2]);
  HalfTurn<S> half;
  if (r2 <= S(0.6)) {  // below pi / 4: sin(r) / r and cos(r) without a root
    half.scale = S(0.5) + S(0.5) * (r2 * detail::polynomial(T::kSin, r2));
    half.w = (S(1) - S(0.5) * r2) + r2 * r2 * detail::polynomial(T::kCos, r2);
  } else {
    half = large_half_turn(r2);
  }
  return Quat<S>(half.w, half.scale * phi[0], half.scale * phi[1], half.scale * phi[2]);
}

/// Unit quaternion -> the shortest rotation vector (rad), |phi| <= pi.
template <class S>
Vec<S, 3> log_so3(const Quat<S>& q) noexcept {
  using T = detail::Trigonometry<S>;
  const S sign = q.w() < S(0) ? S(-1) : S(1);  // q and -q are the same rotation
  const S w = sign * q.w();
  const S sine2 = q.x() * q.x() + q.y() * q.y() + q.z() * q.z();
  S scale;                         // of half the angle: atan(sine / w) / sine
  if (sine2 <= S(0.17) * w * w) {  // below tan(pi / 8), without a root
    const S inverse = S(1) / w;
    const S z2 = sine2 * inverse * inverse;
    scale = inverse + inverse * (z2 * detail::polynomial(T::kAtan, z2));
  } else {
    const S sine = std::sqrt(sine2);
    scale = atan2(sine, w) / sine;
  }
  const S factor = S(2) * sign * scale;
  return {factor * q.x(), factor * q.y(), factor * q.z()};
}

}  // namespace articam::math
