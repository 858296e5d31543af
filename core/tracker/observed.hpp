#pragma once
/// @file  What a frame alone says of each degree of freedom, whatever was known before.

#include "core/tracker/motion_prior.hpp"
#include "core/tracker/normal_equations.hpp"
#include "core/tracker/tracking_status.hpp"

namespace articam::tracker {

template <class M>
using Observabilities = std::array<Observability, static_cast<std::size_t>(model::kDof<M>)>;

/// From the covariance that the equations of the matches, `normal`, would leave of a coarse knowledge C (variances, m^2
/// and rad^2):
///
///     P = (A^T W A + C^-1)^-1;   observed below half of C's deviation, held above 99 % of it, else weak
///
/// What the neighbours' correlations take is no observation. All are held where the equations have no solution.
template <class M, class S>
Observabilities<M> observe(Normal<M, S> normal, const Vec<S, model::kDof<M>>& C) noexcept {
  constexpr int kDof = model::kDof<M>;
  Observabilities<M> each{};
  if (normal.status != Status::ok) return each;
  for (int i = 0; i < kDof; ++i) normal.H.at(i, i) += S(1) / C[i];
  Mat<S, kDof, kDof> P;
  if (math::invert(normal.H, P) != Status::ok) return each;
  for (int i = 0; i < kDof; ++i) {
    const S share = P(i, i) / C[i];
    each[static_cast<std::size_t>(i)] = share < S(0.25)   ? Observability::observed
                                        : share < S(0.98) ? Observability::weak
                                                          : Observability::held;
  }
  return each;
}

}  // namespace articam::tracker
