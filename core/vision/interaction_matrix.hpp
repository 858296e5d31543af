#pragma once
/// @file  How a point moves in the image when the camera moves.

#include "core/math/types.hpp"
#include "core/status.hpp"

namespace articam::vision {

inline constexpr double kMinDepth_m = 1e-3;

/// Interaction matrix L of one image point s = (x, y):   sdot = L v
///
///     L = | -1/Z    0    x/Z    x y    -(1+x^2)    y |
///         |   0   -1/Z   y/Z   1+y^2    -x y      -x |
///
/// Shapes  s 2x1, L 2x6.
/// Frames  v is the twist of the camera relative to the object, written in {cam}, ordered
///         (vx vy vz wx wy wz). An object that moves in front of a camera at rest sees -L.
/// Units   s: metric image plane at Z = 1 (never pixels). Z: m. v: m/s, rad/s.
/// Errors  behind_camera when Z < kMinDepth_m, or when Z is not a number.
/// Source  Chaumette & Hutchinson, "Visual servo control, part I", IEEE RAM 13(4), 2006.
template <class S>
Result<Mat<S, 2, 6>> interaction_matrix(const Vec<S, 2>& s, S Z_m) noexcept {
  if (!(Z_m >= S(kMinDepth_m))) return Status::behind_camera;  // also catches NaN
  const S x = s.x(), y = s.y();
  const S rho = S(1) / Z_m;  // inverse depth, 1/m
  Mat<S, 2, 6> L;
  // clang-format off
  L << -rho,  S(0), x * rho,        x * y, -(S(1) + x * x),  y,
       S(0),  -rho, y * rho, S(1) + y * y,          -x * y, -x;
  // clang-format on
  return L;
}

}  // namespace articam::vision
