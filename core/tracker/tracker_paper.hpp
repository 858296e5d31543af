#pragma once
/// @file  The paper's mode inside the tracker: one step of (5) and (6) a frame. See tracker.hpp.

#include <cmath>

#include "core/tracker/tracker.hpp"

namespace articam::tracker {

template <class Model, class Scalar>
void Tracker<Model, Scalar>::paper_step() noexcept {
  System<Model, Scalar> system;
  found_.solution.status = stack(matches_, q_, FeatureKind::point, system);
  if (found_.solution.status != Status::ok || count<Model, Scalar>(matches_) == 0) return;
  // The covariance is of our making: the paper gives none.
  Normal<Model, Scalar> normal = linearise(matches_, q_, FeatureKind::point);
  found_.solution.error_norm = std::sqrt(normal.error2);
  Prior<Model, Scalar> prior = motion_.prior();
  prior.mean = q_;
  if (normal.status == Status::ok) add_prior(prior, q_, normal);
  found_.solution.status =
      normal.status == Status::ok ? math::invert(normal.H, found_.solution.covariance) : normal.status;
  if (found_.solution.status != Status::ok) return;
  found_.solution.chi2 = normal.chi2;

  if (options_.feed_forward) filter_feature_rates();
  paper_rates_ = control_law(system, gain(options_.gain, found_.solution.error_norm), s_star_dot_);
  q_ = paper_.integrate(q_, paper_rates_, period_s_);
  found_.solution.iterations = 1;
}

/// s_star_dot of (5): differences of features that both frames show, through a low pass of the first order.
template <class Model, class Scalar>
void Tracker<Model, Scalar>::filter_feature_rates() noexcept {
  const Scalar share = period_s_ / (static_cast<Scalar>(options_.feed_forward_time_s) + period_s_);
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    auto rate = s_star_dot_.template segment<2>(static_cast<Eigen::Index>(2 * i));
    if (matches_[i].matched && previous_matches_[i].matched && period_s_ > Scalar(0)) {
      const Vec<Scalar, 2> raw = (matches_[i].s_star - previous_matches_[i].s_star) / period_s_;
      rate += share * (raw - rate);
    } else {
      rate.setZero();
    }
  }
}

}  // namespace articam::tracker
