#pragma once
/// @file  The pseudo-inverse of a small matrix of any rank.

#include <cmath>
#include <limits>

#include "core/math/types.hpp"

namespace articam::math {

/// Eigenvalues (in no order) and eigenvectors (columns of V) of a symmetric matrix, by cyclic Jacobi rotations: every
/// product is a plane rotation, so no size can make Eigen reach for the heap, and the sweeps are counted.
/// Source  Golub & Van Loan, "Matrix computations", 4th ed., section 8.5; convergence is quadratic, 5 to 8 sweeps.
template <class S, int N>
struct SymmetricEigen {
  Vec<S, N> values;
  Mat<S, N, N> V = zeros<Mat<S, N, N>>();

  explicit SymmetricEigen(Mat<S, N, N> D) noexcept {
    for (int i = 0; i < N; ++i) V(i, i) = S(1);
    constexpr int kMaxSweeps = 20;
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
      bool rotated = false;
      for (int p = 0; p < N; ++p) {
        for (int q = p + 1; q < N; ++q) rotated |= rotate(D, p, q);
      }
      if (!rotated) break;
    }
    for (int i = 0; i < N; ++i) values[i] = D(i, i);
  }

 private:
  /// D <- J^T D J with the plane rotation that makes D(p, q) zero.
  bool rotate(Mat<S, N, N>& D, int p, int q) noexcept {
    // Below this the rotation would not change a bit of the diagonal.
    const S eps = std::numeric_limits<S>::epsilon();
    if (!(D(p, q) * D(p, q) > eps * eps * std::abs(D(p, p) * D(q, q)) + std::numeric_limits<S>::min())) return false;
    const S tau = (D(q, q) - D(p, p)) / (S(2) * D(p, q));
    const S t = (tau < S(0) ? S(-1) : S(1)) / (std::abs(tau) + std::sqrt(S(1) + tau * tau));
    const S cosine = S(1) / std::sqrt(S(1) + t * t), sine = t * cosine;
    const auto turn = [&](S& a, S& b) {
      const S kept = a;
      a = cosine * kept - sine * b, b = sine * kept + cosine * b;
    };
    for (int i = 0; i < N; ++i) turn(D(p, i), D(q, i));
    for (int i = 0; i < N; ++i) turn(D(i, p), D(i, q));
    for (int i = 0; i < N; ++i) turn(V(i, p), V(i, q));
    return true;
  }
};

/// pinv(A) b, the shortest of all x that minimise |A x - b|, for any rank of A (M x N, M and N known).
///
/// From the eigenvectors of A^T A; one refinement on the residual of A itself gives back the digits that squaring the
/// condition number costs. Singular values below 1e-6 (double; 1e-3 float) of the largest count as zero.
template <class S, int M, int N>
Vec<S, N> pseudo_inverse_times(const Mat<S, M, N>& A, const Vec<S, M>& b) noexcept {
  Mat<S, N, N> AtA;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      S sum{0};
      for (int k = 0; k < M; ++k) sum += A(k, i) * A(k, j);
      AtA(i, j) = sum;
    }
  }
  const SymmetricEigen<S, N> eigen(AtA);
  S largest{0};
  for (int i = 0; i < N; ++i) largest = eigen.values[i] > largest ? eigen.values[i] : largest;
  const S cut = (sizeof(S) == 4 ? S(1e-6) : S(1e-12)) * largest;

  auto x = zeros<Vec<S, N>>();
  Vec<S, M> residual = b;
  for (int pass = 0; pass < 2; ++pass) {
    Vec<S, N> step = zeros<Vec<S, N>>();
    for (int i = 0; i < N; ++i) {
      if (!(eigen.values[i] > cut)) continue;
      S along{0};  // of the eigenvector, V^T A^T residual
      for (int k = 0; k < M; ++k) {
        S image{0};
        for (int j = 0; j < N; ++j) image += A(k, j) * eigen.V(j, i);
        along += image * residual[k];
      }
      for (int j = 0; j < N; ++j) step[j] += eigen.V(j, i) * (along / eigen.values[i]);
    }
    for (int j = 0; j < N; ++j) x[j] += step[j];
    for (int k = 0; k < M; ++k) {
      for (int j = 0; j < N; ++j) residual[k] -= A(k, j) * step[j];
    }
  }
  return x;
}

}  // namespace articam::math
