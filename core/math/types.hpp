#pragma once
/// @file  Fixed-size vectors, matrices and quaternions. Nothing here can allocate.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace articam {

template <class Scalar, int Rows, int Cols>
using Mat = Eigen::Matrix<Scalar, Rows, Cols>;
template <class Scalar, int Rows>
using Vec = Eigen::Matrix<Scalar, Rows, 1>;
/// Unit quaternion; written w x y z everywhere (Eigen's constructor takes that order too).
template <class Scalar>
using Quat = Eigen::Quaternion<Scalar>;

namespace math {

/// True when every coefficient is a finite number. Needs no libm: x - x is 0 only then.
template <class Derived>
bool all_finite(const Eigen::MatrixBase<Derived>& m) noexcept {
  return ((m - m).array() == typename Derived::Scalar(0)).all();
}
template <class Scalar>
constexpr bool is_finite(Scalar x) noexcept {
  return x - x == Scalar(0);
}

}  // namespace math
}  // namespace articam
