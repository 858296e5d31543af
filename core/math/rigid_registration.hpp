#pragma once
/// @file  The rigid pose between two sets of paired points.

#include <Eigen/SVD>
#include <span>

#include "core/math/se3.hpp"
#include "core/status.hpp"

namespace articam::math {

/// T_a_b that minimises  sum_i | T_a_b p_b[i] - p_a[i] |^2.
///
/// Shapes  as many points in p_a as in p_b, at least 3 of them not on a line.
/// Units   any, the same in both.
/// Errors  bad_argument when the sizes differ; too_few_features below 3 points; ill_conditioned when the points are
///         collinear or not finite.
/// Source  Paolillo et al., equation (7): R = V U^T from the SVD of the cross-covariance; the paper omits the guard
///         against a reflection, det(V U^T) = -1, which noise on nearly coplanar points produces.
template <class S>
Result<Pose<S>> rigid_registration(std::span<const Vec<S, 3>> p_a, std::span<const Vec<S, 3>> p_b) noexcept {
  if (p_a.size() != p_b.size()) return Status::bad_argument;
  if (p_a.size() < 3) return Status::too_few_features;
  Vec<S, 3> mean_a = Vec<S, 3>::Zero(), mean_b = Vec<S, 3>::Zero();
  for (std::size_t i = 0; i < p_a.size(); ++i) mean_a += p_a[i], mean_b += p_b[i];
  mean_a /= static_cast<S>(p_a.size());
  mean_b /= static_cast<S>(p_b.size());

  Mat<S, 3, 3> covariance = Mat<S, 3, 3>::Zero();  // sum of (p_b - mean)(p_a - mean)^T = U Sigma V^T
  for (std::size_t i = 0; i < p_a.size(); ++i) covariance += (p_b[i] - mean_b) * (p_a[i] - mean_a).transpose();
  if (!all_finite(covariance)) return Status::ill_conditioned;

  const Eigen::JacobiSVD<Mat<S, 3, 3>, Eigen::NoQRPreconditioner> svd(covariance,
                                                                      Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()[1] > S(1e-6) * svd.singularValues()[0])) return Status::ill_conditioned;
  const Mat<S, 3, 3> u = svd.matrixU(), v = svd.matrixV();
  Vec<S, 3> guard{S(1), S(1), S(1)};
  if ((v * u.transpose()).determinant() < S(0)) guard.z() = S(-1);
  const Mat<S, 3, 3> R = v * guard.asDiagonal() * u.transpose();
  Pose<S> T_a_b;
  T_a_b.R = Quat<S>(R).normalized();
  T_a_b.t = mean_a - T_a_b.R * mean_b;
  return T_a_b;
}

}  // namespace articam::math
