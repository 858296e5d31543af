#pragma once
/// @file  Small symmetric systems: the Cholesky factor of a normal matrix, and the pseudo-inverse.

#include <Eigen/Jacobi>
#include <cmath>
#include <limits>

#include "core/math/types.hpp"
#include "core/status.hpp"

namespace articam::math {

/// H = L D L^T of a symmetric positive definite matrix, N known at compile time.
template <class S, int N>
class Cholesky {
 public:
  /// Reads the lower triangle. Errors  ill_conditioned when a pivot is not positive, or not a number.
  Status factorise(const Mat<S, N, N>& H) noexcept {
    for (int j = 0; j < N; ++j) {
      S d = H(j, j);
      for (int k = 0; k < j; ++k) d -= L_(j, k) * L_(j, k) * D_[k];
      if (!(d > std::numeric_limits<S>::min()) || !is_finite(d)) return Status::ill_conditioned;
      D_[j] = d;
      const S inverse = S(1) / d;
      for (int i = j + 1; i < N; ++i) {
        S l = H(i, j);
        for (int k = 0; k < j; ++k) l -= L_(i, k) * L_(j, k) * D_[k];
        L_(i, j) = l * inverse;
      }
    }
    return Status::ok;
  }

  /// x of H x = b; only after factorise() returned ok.
  Vec<S, N> solve(Vec<S, N> x) const noexcept {
    for (int i = 0; i < N; ++i) {
      for (int k = 0; k < i; ++k) x[i] -= L_(i, k) * x[k];
    }
    for (int i = N - 1; i >= 0; --i) {
      x[i] /= D_[i];
      for (int k = i + 1; k < N; ++k) x[i] -= L_(k, i) * x[k];
    }
    return x;
  }

  /// H^-1, symmetric to the bit.
  Mat<S, N, N> inverse() const noexcept {
    Mat<S, N, N> X;
    for (int j = 0; j < N; ++j) {
      const Vec<S, N> x = solve(Vec<S, N>::Unit(j));
      for (int i = j; i < N; ++i) X(i, j) = X(j, i) = x[i];
    }
    return X;
  }

 private:
  Mat<S, N, N> L_ = Mat<S, N, N>::Identity();
  Vec<S, N> D_ = Vec<S, N>::Ones();
};

/// Eigenvalues (in no order) and eigenvectors (columns of V) of a symmetric matrix, by cyclic Jacobi rotations: every
/// product is a plane rotation, so no size can make Eigen reach for the heap, and the sweeps are counted.
/// Source  Golub & Van Loan, "Matrix computations", 4th ed., section 8.5; convergence is quadratic, 5 to 8 sweeps.
template <class S, int N>
struct SymmetricEigen {
  Vec<S, N> values;
  Mat<S, N, N> V = Mat<S, N, N>::Identity();

  explicit SymmetricEigen(Mat<S, N, N> D) noexcept {
    constexpr int kMaxSweeps = 20;
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
      bool rotated = false;
      for (int p = 0; p < N; ++p) {
        for (int q = p + 1; q < N; ++q) rotated |= rotate(D, p, q);
      }
      if (!rotated) break;
    }
    values = D.diagonal();
  }

 private:
  bool rotate(Mat<S, N, N>& D, int p, int q) noexcept {
    // Below this the rotation would not change a bit of the diagonal.
    const S eps = std::numeric_limits<S>::epsilon();
    if (!(D(p, q) * D(p, q) > eps * eps * std::abs(D(p, p) * D(q, q)) + std::numeric_limits<S>::min())) return false;
    Eigen::JacobiRotation<S> J;
    J.makeJacobi(D, p, q);
    D.applyOnTheLeft(p, q, J.adjoint());
    D.applyOnTheRight(p, q, J);
    V.applyOnTheRight(p, q, J);
    return true;
  }
};

/// pinv(A) b, the shortest of all x that minimise |A x - b|, for any rank of A (M x N, M and N known).
///
/// From the eigenvectors of A^T A; one refinement on the residual of A itself gives back the digits that squaring the
/// condition number costs. Singular values below 1e-6 (double; 1e-3 float) of the largest count as zero.
template <class S, int M, int N>
Vec<S, N> pseudo_inverse_times(const Mat<S, M, N>& A, const Vec<S, M>& b) noexcept {
  const SymmetricEigen<S, N> eigen(A.transpose().lazyProduct(A));
  const S cut = (sizeof(S) == 4 ? S(1e-6) : S(1e-12)) * eigen.values.maxCoeff();
  const auto apply = [&](const Vec<S, M>& residual) -> Vec<S, N> {
    const Vec<S, N> projected = A.transpose().lazyProduct(residual);
    Vec<S, N> y = eigen.V.transpose().lazyProduct(projected);
    for (int i = 0; i < N; ++i) y[i] = eigen.values[i] > cut ? y[i] / eigen.values[i] : S(0);
    return eigen.V.lazyProduct(y);
  };
  const Vec<S, N> x = apply(b);
  const Vec<S, M> residual = b - A.lazyProduct(x);
  return x + apply(residual);
}

}  // namespace articam::math
