#pragma once
/// @file  Virtual visual servoing iterated to convergence inside one frame: the default solver.

#include "core/math/least_squares.hpp"
#include "core/math/robust_weights.hpp"
#include "core/tracker/articulation_matrix.hpp"

namespace articam::tracker {

/// Where the configuration is expected before the frame is looked at.
template <class M, class S>
struct Prior {
  model::Configuration<M, S> mean{};
  Vec<S, model::kDof<M>> variance = Vec<S, model::kDof<M>>::Ones();  ///< m^2, rad^2
};

/// The normal equations of one step:  H step = -g, and the cost at the configuration they were built at.
template <class M, class S>
struct Normal {
  Mat<S, model::kDof<M>, model::kDof<M>> H;
  Vec<S, model::kDof<M>> g;
  S cost{};
  S chi2{};        ///< the measurements' part without robust weights
  S error_norm{};  ///< ||e||, metric image plane
};

template <class M, class S>
struct Solution {
  model::Configuration<M, S> q{};
  Mat<S, model::kDof<M>, model::kDof<M>> covariance = Mat<S, model::kDof<M>, model::kDof<M>>::Identity();
  Status status{Status::ill_conditioned};
  bool converged{};
  int iterations{};
  S cost{};        ///< measurements (Huber) and prior, half squared standard deviations
  S chi2{};        ///< sum of squared normalised distances, no weights, no prior
  S error_norm{};  ///< ||e|| at the start
};

/// H = A^T W A + P^-1 and g = A^T W e + P^-1 (q - q_prior), with Huber weights of the 2-D distances inside W.
template <class M, class S>
Normal<M, S> normal_equations(const System<M, S>& system, const Vec<S, model::kDof<M>>& from_prior,
                              const Vec<S, model::kDof<M>>& prior_variance) noexcept {
  constexpr int kDof = model::kDof<M>;
  Normal<M, S> normal;
  normal.error_norm = system.e.norm();
  const Vec<S, kDof> information = prior_variance.cwiseInverse();
  normal.H = information.asDiagonal();
  normal.g = information.cwiseProduct(from_prior);
  normal.cost = S(0.5) * from_prior.dot(normal.g);
  for (int i = 0; i < model::kNumMarkers<M>; ++i) {
    if (!(system.variance[i] > S(0))) continue;
    const S certainty = S(1) / system.variance[i];
    const Vec<S, 2> e = system.e.template segment<2>(2 * i);
    const S distance2 = e.squaredNorm() * certainty;
    // k = 3: the 2-D distance of a good match exceeds it once in 90 (Rayleigh).
    const S weight = math::huber_weight(distance2, S(3)) * certainty;
    normal.cost += math::huber_loss(distance2, S(3));
    normal.chi2 += distance2;
    const Mat<S, 2, kDof> A_i = system.A.template middleRows<2>(2 * i);
    for (int c = 0; c < kDof; ++c) {
      const Vec<S, 2> column = A_i.col(c) * weight;
      normal.g[c] += column.dot(e);
      for (int r = c; r < kDof; ++r) normal.H(r, c) += column.dot(A_i.col(r));  // lower triangle
    }
  }
  return normal;
}

/// The equations of one step at q. Errors  behind_camera; `normal` is then unchanged.
template <class M, class S>
Status linearise(const Matches<M, S>& matches, const Prior<M, S>& prior, const model::Configuration<M, S>& q,
                 Normal<M, S>& normal) noexcept {
  System<M, S> system;
  if (const Status status = stack(matches, q, FeatureKind::imaged_circle, system); status != Status::ok) return status;
  normal = normal_equations(system, model::difference(prior.mean, q), prior.variance);
  return Status::ok;
}

/// The Gauss-Newton step, its diagonal raised by the damping (Levenberg, Marquardt): (5) with lambda = 1 and the
/// pseudo-inverse weighted. Errors  ill_conditioned; `step` is then unchanged.
template <class M, class S>
Status damped_step(const Normal<M, S>& normal, S damping, Vec<S, model::kDof<M>>& step) noexcept {
  Mat<S, model::kDof<M>, model::kDof<M>> damped = normal.H;
  damped.diagonal() *= S(1) + damping;
  math::Cholesky<S, model::kDof<M>> cholesky;
  if (const Status status = cholesky.factorise(damped); status != Status::ok) return status;
  step = -cholesky.solve(normal.g);
  return Status::ok;
}

/// Minimises  1/2 sum rho(|e_i|^2 / sigma_i^2) + 1/2 |q - q_prior|^2_P  by damped steps, each kept only if it does not
/// raise the cost. Errors  behind_camera or ill_conditioned in Solution::status; q is then the start.
template <class M, class S>
Solution<M, S> solve(const Matches<M, S>& matches, const Prior<M, S>& prior, const model::Configuration<M, S>& start,
                     int max_iterations) noexcept {
  // In standard deviations: such a step is lost in the noise. In float, rounding of s alone makes 6e-3 of 0.005 px.
  constexpr S kStill = sizeof(S) == 4 ? S(3e-2) : S(1e-3);
  // Rounding of the cost: relative where it is large, and near the optimum what the rounding of s makes of it.
  constexpr S kRelative = sizeof(S) == 4 ? S(1e-4) : S(1e-10), kAbsolute = sizeof(S) == 4 ? S(1e-2) : S(1e-9);
  Solution<M, S> solution;
  solution.q = start;
  Normal<M, S> normal, trial;
  solution.status = linearise(matches, prior, start, normal);
  if (solution.status != Status::ok) return solution;
  solution.error_norm = normal.error_norm;

  S damping{0};
  while (solution.iterations < max_iterations && !solution.converged) {
    ++solution.iterations;
    Vec<S, model::kDof<M>> step;
    bool better = false;
    if (damped_step<M, S>(normal, damping, step) == Status::ok) {
      const auto q = model::integrate<M, S>(solution.q, step);
      better = linearise(matches, prior, q, trial) == Status::ok &&
               trial.cost <= normal.cost * (S(1) + kRelative) + kAbsolute;
      if (better) {
        // step^T H step; a step that damping holds back tells nothing
        solution.converged = damping <= S(1e-3) && -step.dot(normal.g) < kStill * kStill;
        solution.q = q;
        normal = trial;
      }
    }
    damping = better ? (damping > S(1e-6) ? S(0.1) * damping : S(0)) : (damping > S(0) ? S(10) * damping : S(1e-3));
  }
  solution.cost = normal.cost;
  solution.chi2 = normal.chi2;
  math::Cholesky<S, model::kDof<M>> cholesky;
  solution.status = cholesky.factorise(normal.H);
  if (solution.status == Status::ok) solution.covariance = cholesky.inverse();
  return solution;
}

}  // namespace articam::tracker
