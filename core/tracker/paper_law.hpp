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
  A.template middleCols<3>(3) *= S(2);
  const Vec<S, System<M, S>::kRows> wanted = s_star_dot - lambda * system.e;
  Vec<S, model::kDof<M>> rates = math::pseudo_inverse_times<S, System<M, S>::kRows, model::kDof<M>>(A, wanted);
  rates.template segment<3>(3) *= S(2);
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
    const Rates step = (qdot + previous_) * (S(0.5) * period_s);
    next.T_cam_obj.t = q.T_cam_obj.t + step.template head<3>();
    const Vec<S, 3> turn = previous_.template segment<3>(3) * period_s;
    next.T_cam_obj.R = math::exp_so3<S>(turn) * q.T_cam_obj.R;
    next.joints = q.joints + step.template tail<n>();
    previous_ = qdot;
    return next;
  }
  void reset() noexcept { previous_.setZero(); }

 private:
  Rates previous_ = Rates::Zero();
};

}  // namespace articam::tracker
