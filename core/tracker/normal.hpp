#pragma once
/// @file  The normal equations of one step as numbers, and the prior that may be added to them.

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

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

namespace detail {

/// H += P^-1,  pull = P^-1 e.  A row at a time: with its length known, its loop unrolls.
template <class M, class S, std::size_t... kRow>
[[gnu::always_inline]] inline void add_information(const typename Prior<M, S>::Square& information,
                                                   const Vec<S, model::kDof<M>>& e, Normal<M, S>& normal,
                                                   Vec<S, model::kDof<M>>& pull,
                                                   std::index_sequence<kRow...>) noexcept {
  S* entry = normal.H.entries.data();  // row by row, from the diagonal to the first column
  const auto add_row = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) __attribute__((always_inline)) {
    constexpr auto row = static_cast<Eigen::Index>(i);
    *entry++ += information(row, row);
    pull[row] = information(row, row) * e[row];
    for (Eigen::Index j = row - 1; j >= 0; --j) {
      const S common = information(j, row);
      *entry++ += common;
      pull[row] += common * e[j];
      pull[j] += common * e[row];
    }
  };
  (add_row(std::integral_constant<std::size_t, kRow>{}), ...);
}

/// What else H gets where the rotation is turned by 2 `half` from the prior's, in the first order: J^T P^-1 J - P^-1.
template <class M, class S>
void turn_information(const typename Prior<M, S>::Square& information, const Vec<S, 3>& half,
                      Normal<M, S>& normal) noexcept {
  Mat<S, 3, model::kDof<M>> common;  // of the rotation with all
  for (int i = 0; i < model::kDof<M>; ++i) {
    const Vec<S, 3> column = information.template block<3, 1>(3, i);
    common.col(i) = column.cross(half);
  }
  for (int i = 0; i < 3; ++i) {
    const Vec<S, 3> row = common.template block<1, 3>(i, 3).transpose();
    const Vec<S, 3> twice = row.cross(half);
    for (int j = 0; j < 3; ++j) normal.H.at(3 + i, j) += common(i, j);
    for (int j = 0; j <= i; ++j) normal.H.at(3 + i, 3 + j) += common(i, 3 + j) + common(j, 3 + i) + twice[j];
    for (int k = 6; k < model::kDof<M>; ++k) normal.H.at(k, 3 + i) += common(i, k);
  }
}

}  // namespace detail

/// Adds the prior:  H += J^T P^-1 J,  b += J^T P^-1 e,  e = q_prior - q, which a step changes by -J step: J is the
/// identity but for the rotation, where it is the inverse of exp's right Jacobian, I + X/2 + X^2/12 of the turn. H says
/// how long a step is, not where it ends: up to 0.1 rad its J is taken for the identity.
template <class M, class S>
void add_prior(const Prior<M, S>& prior, const model::Configuration<M, S>& q, Normal<M, S>& normal) noexcept {
  const Vec<S, model::kDof<M>> e = model::difference(q, prior.mean);
  Vec<S, model::kDof<M>> pull;
  detail::add_information<M, S>(prior.information, e, normal, pull, std::make_index_sequence<model::kDof<M>>{});
  S cost{};
  for (int i = 0; i < model::kDof<M>; ++i) cost += e[i] * pull[i];
  normal.cost += S(0.5) * cost;

  const Vec<S, 3> half = S(0.5) * e.template segment<3>(3), torque = pull.template segment<3>(3);
  const Vec<S, 3> turned = half.cross(torque);
  pull.template segment<3>(3) += S(1.0 / 3) * half.cross(turned) - turned;
  for (int i = 0; i < model::kDof<M>; ++i) normal.b[static_cast<std::size_t>(i)] += pull[i];
  if (half.squaredNorm() > S(0.05 * 0.05)) detail::turn_information<M, S>(prior.information, half, normal);
}

}  // namespace articam::tracker
