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

/// A matrix of zeros. Eigen's own Zero() is an expression, and costs each size of matrix its classes.
template <class Matrix>
Matrix zeros() noexcept {
  Matrix m;
  for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = typename Matrix::Scalar(0);
  return m;
}

/// Needs no libm: x - x is 0 only of a finite number.
template <class Scalar>
constexpr bool is_finite(Scalar x) noexcept {
  return x - x == Scalar(0);
}
/// True when every coefficient is a finite number.
template <class Scalar, int Rows, int Cols>
bool all_finite(const Mat<Scalar, Rows, Cols>& m) noexcept {
  for (int i = 0; i < m.size(); ++i) {
    if (!is_finite(m.data()[i])) return false;
  }
  return true;
}

}  // namespace math
}  // namespace articam
