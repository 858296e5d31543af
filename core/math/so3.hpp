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

/// Rotation vector (rad) -> unit quaternion.
template <class S>
Quat<S> exp_so3(const Vec<S, 3>& phi) noexcept {
  const S angle2 = phi.squaredNorm();
  const S angle = std::sqrt(angle2);
  S scale, w;  // quaternion (w, scale * phi)
  if (angle2 < std::sqrt(std::numeric_limits<S>::epsilon())) {
    // Series of sin(a/2)/a and cos(a/2): the first dropped term is below the last bit.
    scale = S(0.5) - angle2 * (S(1) / 48 - angle2 / 3840);
    w = S(1) - angle2 * (S(1) / 8 - angle2 / 384);
  } else {
    const auto half = sin_cos(S(0.5) * angle);
    scale = half.sin / angle;
    w = half.cos;
  }
  return Quat<S>(w, scale * phi.x(), scale * phi.y(), scale * phi.z());
}

/// Unit quaternion -> the shortest rotation vector (rad), |phi| <= pi.
template <class S>
Vec<S, 3> log_so3(const Quat<S>& q) noexcept {
  const S sign = q.w() < S(0) ? S(-1) : S(1);  // q and -q are the same rotation
  const Vec<S, 3> v = sign * q.vec();
  const S w = sign * q.w();
  const S sine = v.norm();
  // atan2(s, w)/s -> 1/w as s -> 0; the next term is -s^2/(3 w^3).
  const S scale = sine < std::sqrt(std::numeric_limits<S>::epsilon())
                      ? S(2) / w - S(2) * sine * sine / (S(3) * w * w * w)
                      : S(2) * atan2(sine, w) / sine;
  return scale * v;
}

}  // namespace articam::math
