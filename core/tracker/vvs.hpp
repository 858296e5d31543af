#pragma once
/// @file  Virtual visual servoing iterated to convergence inside one frame: the default solver.

#include <cmath>

#include "core/tracker/joint_limits.hpp"

namespace articam::tracker {

template <class M, class S>
struct Solution {
  model::Configuration<M, S> q{};
  Mat<S, model::kDof<M>, model::kDof<M>> covariance = math::zeros<Mat<S, model::kDof<M>, model::kDof<M>>>();
  Status status{Status::ill_conditioned};
  bool converged{};
  bool beyond_limit{};  ///< a joint is held at its limit, and the marks want it farther by more than 3 deviations
  int iterations{};
  S cost{};        ///< measurements (Huber) and prior, half squared standard deviations
  S chi2{};        ///< sum of squared normalised distances, no weights, no prior
  S error_norm{};  ///< ||e|| at the start
  S scale{};       ///< what the marks are too large by, relative
};

/// step^T H step = step^T b of an undamped step, the scale's included.
template <class M, class S>
S decrement(const Normal<M, S>& normal, const Vec<S, model::kDof<M>>& step) noexcept {
  S sum = normal.scale.pull * normal.scale.variance * normal.scale.pull;
  for (std::size_t i = 0; i < normal.b.size(); ++i) sum += step[static_cast<Eigen::Index>(i)] * normal.b[i];
  return sum;
}

/// The equations of one step at q, matches and prior.
template <class M, class S>
Normal<M, S> linearise(const Matches<M, S>& matches, const Prior<M, S>& prior, const model::Configuration<M, S>& q,
                       S scale = S(0)) noexcept {
  Normal<M, S> normal = linearise(matches, q, FeatureKind::imaged_circle, scale);
  if (normal.status == Status::ok) add_prior(prior, q, normal);
  return normal;
}

/// The marks draw a joint that is held outwards, by P b for its variance P: more than 3 of its deviations.
template <class M, class S>
bool is_beyond_limit(const Normal<M, S>& normal, const Mat<S, model::kDof<M>, model::kDof<M>>& P,
                     const HeldJoints<M>& held) noexcept {
  for (std::size_t j = 0; j < held.size(); ++j) {
    const int k = 6 + static_cast<int>(j);
    const S outwards = static_cast<S>(held[j]) * normal.b[static_cast<std::size_t>(k)];
    if (outwards > S(0) && outwards * outwards * P(k, k) > S(9)) return true;
  }
  return false;
}

/// Minimises  1/2 sum rho(|e_i|^2 / sigma_i^2) + 1/2 |q - q_prior|^2_P  by damped steps, each kept only if it does not
/// raise the cost, and none takes a joint beyond its limits if it is to stay `within_limits`. The covariance does not
/// count on those: that of the marks and the prior alone.
/// Errors  behind_camera or ill_conditioned in Solution::status; q is then the start.
template <class M, class S>
Solution<M, S> solve(const Matches<M, S>& matches, const Prior<M, S>& prior, const model::Configuration<M, S>& start,
                     int max_iterations, bool within_limits = true) noexcept {
  // In standard deviations: such a step is lost in the noise. In float, rounding of s alone makes 6e-3 of 0.005 px.
  constexpr S kStill = sizeof(S) == 4 ? S(3e-2) : S(1e-3);
  // Rounding of the cost: relative where it is large, and near the optimum what the rounding of s makes of it.
  constexpr S kRelative = sizeof(S) == 4 ? S(1e-4) : S(1e-10), kAbsolute = sizeof(S) == 4 ? S(1e-2) : S(1e-9);
  Solution<M, S> solution;
  solution.q = start;
  Normal<M, S> normal = linearise(matches, prior, start);
  solution.status = normal.status;
  if (solution.status != Status::ok) return solution;
  solution.error_norm = std::sqrt(normal.error2);

  S damping{0};
  HeldJoints<M> held{};
  while (solution.iterations < max_iterations && !solution.converged) {
    ++solution.iterations;
    Vec<S, model::kDof<M>> step;
    bool better = false;
    const Status found = within_limits ? limited_step<M, S>(normal, damping, solution.q, step, held)
                                       : damped_step<M, S>(normal, damping, step);
    if (found == Status::ok) {
      // step^T H step; a step that damping holds back tells nothing
      solution.converged = damping <= S(1e-3) && decrement<M, S>(normal, step) < kStill * kStill;
      const auto q = model::integrate<M, S>(solution.q, step);
      const S scale = solution.scale + normal.scale.step_of(step);
      const Normal<M, S> trial = linearise(matches, prior, q, scale);
      better = trial.status == Status::ok && trial.cost <= normal.cost * (S(1) + kRelative) + kAbsolute;
      if (better) solution.q = q, solution.scale = scale, normal = trial;
    }
    damping = better ? (damping > S(1e-6) ? S(0.1) * damping : S(0)) : (damping > S(0) ? S(10) * damping : S(1e-3));
  }
  solution.cost = normal.cost;
  solution.chi2 = normal.chi2;
  solution.status = math::invert(normal.H, solution.covariance);
  solution.beyond_limit = is_beyond_limit<M, S>(normal, solution.covariance, held);
  return solution;
}

}  // namespace articam::tracker
