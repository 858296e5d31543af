#pragma once
/// @file  The normal equations of one step as numbers, and the prior that may be added to them.

#include <array>
#include <cstddef>

#include "core/math/so3.hpp"
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

/// Adds the prior:  H += J^T P^-1 J,  b += J^T P^-1 e,  e = q_prior - q, which a step changes by -J step: J is the
/// identity but for the rotation, where it is the inverse of exp's right Jacobian, to the second order of the turn.
/// Turned by less than a milliradian, J is taken for the identity.
template <class M, class S>
void add_prior(const Prior<M, S>& prior, const model::Configuration<M, S>& q, Normal<M, S>& normal) noexcept {
  const Vec<S, model::kDof<M>> e = model::difference(q, prior.mean);
  Vec<S, model::kDof<M>> pull = prior.information.lazyProduct(e);
  S cost{};
  for (int i = 0; i < model::kDof<M>; ++i) cost += e[i] * pull[i];
  normal.cost += S(0.5) * cost;

  const auto add = [&](const typename Prior<M, S>::Square& information) {
    S* entry = normal.H.entries.data();  // row by row, from the diagonal to the first column
    for (int i = 0; i < model::kDof<M>; ++i) {
      for (int j = i; j >= 0; --j) *entry++ += information(i, j);
      normal.b[static_cast<std::size_t>(i)] += pull[i];
    }
  };
  const Vec<S, 3> turn = e.template segment<3>(3);
  if (turn.squaredNorm() < S(1e-6)) return add(prior.information);
  const Mat<S, 3, 3> X = math::hat<S>(turn);
  const Mat<S, 3, 3> J = Mat<S, 3, 3>::Identity() + S(0.5) * X + S(1.0 / 12) * X.lazyProduct(X);
  typename Prior<M, S>::Square information = prior.information;
  information.template middleCols<3>(3) = prior.information.template middleCols<3>(3).lazyProduct(J);
  const Mat<S, 3, model::kDof<M>> rows = J.transpose().lazyProduct(information.template middleRows<3>(3));
  information.template middleRows<3>(3) = rows;
  const Vec<S, 3> torque = J.transpose().lazyProduct(pull.template segment<3>(3));
  pull.template segment<3>(3) = torque;
  add(information);
}

}  // namespace articam::tracker
