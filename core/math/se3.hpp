#pragma once
/// @file  A rigid pose: where one frame sits in another.

#include "core/math/so3.hpp"
#include "core/math/types.hpp"

namespace articam {

/// T_a_b, the pose of {b} in {a}: maps points of {b} into {a},  p_a = R_a_b p_b + t_a_b.
template <class S>
struct Pose {
  Quat<S> R{S(1), S(0), S(0), S(0)};  ///< unit quaternion
  Vec<S, 3> t{Vec<S, 3>::Zero()};     ///< m

  Vec<S, 3> operator*(const Vec<S, 3>& p) const noexcept { return R * p + t; }
  /// T_a_c = T_a_b * T_b_c.
  Pose operator*(const Pose& other) const noexcept { return {R * other.R, R * other.t + t}; }
  /// T_b_a.
  Pose inverse() const noexcept { return {R.conjugate(), -(R.conjugate() * t)}; }
};

}  // namespace articam
