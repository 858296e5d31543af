#pragma once
/// @file  The paper's estimator, to the letter: control law (5), gain profile, integration (6).

#include "core/math/least_squares.hpp"
#include "core/math/trigonometry.hpp"
#include "core/tracker/articulation_matrix.hpp"
#include "core/tracker/options.hpp"

namespace articam::tracker {

/// lambda(||e||), 1/s; error_norm on the metric plane.
template <class S>
S gain(const GainProfile& profile, S error_norm) noexcept {
  const S span = static_cast<S>(profile.at_zero - profile.at_infinity);
  if (!(span > S(0))) return static_cast<S>(profile.at_zero);
  return span * math::exp(-static_cast<S>(profile.slope) * error_norm / span) + static_cast<S>(profile.at_infinity);
}

/// qdot = -lambda pinv(A) e + pinv(A) s_star_dot   (5), in the 6 + n tangent coordinates (t, rotation, joints).
///
/// The paper's pinv acts on 7 + n rates and gives the shortest of them. A quaternion's rate is half the rotation's
/// (|sigma_dot| = |omega| / 2), so the rotation is solved for in halves: the same motion, also when A has lost rank.
template <class M, class S>
Vec<S, model::kDof<M>> control_law(const System<M, S>& system, S lambda,
                                   const Vec<S, System<M, S>::kRows>& s_star_dot) noexcept {
  auto A = system.A;
  Vec<S, System<M, S>::kRows> wanted;
  for (Eigen::Index r = 0; r < wanted.size(); ++r) {
    for (Eigen::Index c = 3; c < 6; ++c) A(r, c) *= S(2);
    wanted[r] = s_star_dot[r] - lambda * system.e[r];
  }
  Vec<S, model::kDof<M>> rates = math::pseudo_inverse_times<S, System<M, S>::kRows, model::kDof<M>>(A, wanted);
  for (Eigen::Index c = 3; c < 6; ++c) rates[c] *= S(2);
  return rates;
}

/// Equation (6): base position and joints by the mean of this and the previous rate, the quaternion by the closed-form
/// exponential of the previous angular velocity (in {cam}, hence from the left).
template <class M, class S>
class PaperIntegrator {
 public:
  using Rates = Vec<S, model::kDof<M>>;

  model::Configuration<M, S> integrate(const model::Configuration<M, S>& q, const Rates& qdot, S period_s) noexcept {
    constexpr int n = model::kNumJoints<M>;
    model::Configuration<M, S> next;
    const auto step = [&](Eigen::Index i) { return (qdot[i] + previous_[i]) * (S(0.5) * period_s); };
    for (Eigen::Index i = 0; i < 3; ++i) next.T_cam_obj.t[i] = q.T_cam_obj.t[i] + step(i);
    const Vec<S, 3> turn{previous_[3] * period_s, previous_[4] * period_s, previous_[5] * period_s};
    next.T_cam_obj.R = math::exp_so3<S>(turn) * q.T_cam_obj.R;
    for (Eigen::Index j = 0; j < n; ++j) next.joints[j] = q.joints[j] + step(6 + j);
    previous_ = qdot;
    return next;
  }
  void reset() noexcept { previous_ = math::zeros<Rates>(); }

 private:
  Rates previous_ = math::zeros<Rates>();
};

}  // namespace articam::tracker
