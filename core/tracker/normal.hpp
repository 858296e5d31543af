#pragma once
/// @file  The normal equations of one step as numbers, and the prior that may be added to them.

#include <array>
#include <cstddef>

#include "core/math/tree_factor.hpp"
#include "core/model/configuration.hpp"

namespace articam::tracker {

/// Where the configuration is expected before the frame is looked at.
template <class M, class S>
struct Prior {
  using Square = Mat<S, model::kDof<M>, model::kDof<M>>;
  model::Configuration<M, S> mean{};
  Square information = math::zeros<Square>();  ///< P^-1, 1/m^2, 1/rad^2
};

/// A prior whose degrees of freedom are independent, of these variances (m^2, rad^2).
template <class M, class S>
Prior<M, S> independent_prior(const model::Configuration<M, S>& mean, const Vec<S, model::kDof<M>>& variance) noexcept {
  Prior<M, S> prior{.mean = mean};
  for (int i = 0; i < model::kDof<M>; ++i) prior.information(i, i) = S(1) / variance[i];
  return prior;
}

/// What was eliminated of the equations of (step, step of u), 1 + u being the marks' common scale.
template <class M, class S>
struct EliminatedScale {
  S variance{};  ///< of u, the configuration known; 0 where no shape tells of it
  S pull{};
  std::array<S, static_cast<std::size_t>(model::kDof<M>)> with{};  ///< information in common with the unknowns

  S step_of(const Vec<S, model::kDof<M>>& step) const noexcept {
    S rest = pull;
    for (std::size_t i = 0; i < with.size(); ++i) rest -= with[i] * step[static_cast<Eigen::Index>(i)];
    return variance * rest;
  }
};

/// The normal equations of one step,  H step = b  with b the cost's falling slope, and the cost where they were built.
template <class M, class S>
struct Normal {
  math::TreeMatrix<math::Chain<model::kDof<M>>, S> H;
  std::array<S, static_cast<std::size_t>(model::kDof<M>)> b;
  S cost;
  S chi2;        ///< the centres' part without robust weights
  S shape_chi2;  ///< the shapes'
  S error2;      ///< ||e||^2, metric image plane
  EliminatedScale<M, S> scale;
  Status status;
};

/// Adds the prior:  H += P^-1,  b += P^-1 (q_prior - q).
template <class M, class S>
void add_prior(const Prior<M, S>& prior, const model::Configuration<M, S>& q, Normal<M, S>& normal) noexcept {
  const auto to_mean = model::difference(q, prior.mean);
  S cost{};
  for (int i = 0; i < model::kDof<M>; ++i) {
    S pull{};
    for (int j = 0; j < model::kDof<M>; ++j) pull += prior.information(i, j) * to_mean[j];
    for (int j = 0; j <= i; ++j) normal.H.at(i, j) += prior.information(i, j);
    normal.b[static_cast<std::size_t>(i)] += pull;
    cost += to_mean[i] * pull;
  }
  normal.cost += S(0.5) * cost;
}

}  // namespace articam::tracker
