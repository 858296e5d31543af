#pragma once
/// @file  Between two frames: where the object is expected, how surely, and how fast it moves.

#include "core/timestamp.hpp"
#include "core/tracker/options.hpp"
#include "core/tracker/tracking_status.hpp"
#include "core/tracker/vvs.hpp"

namespace articam::tracker {

/// Constant velocity for the mean. Its standard deviation is what the last frame left and grows at Options::growth_*,
/// which bears changes of speed; as a prior for the next frame it never falls below Options::prior_*.
template <class M, class S>
class MotionPrior {
 public:
  static constexpr int kDof = model::kDof<M>;
  using Rates = Vec<S, kDof>;
  using Configuration = model::Configuration<M, S>;

  explicit MotionPrior(const Options& options) noexcept : options_{options} {}

  void start(const Configuration& q0) noexcept {
    restart(q0);
    has_time_ = false;
  }

  /// Moves the prior to time t. Returns the span since the last frame, s; 0 where it is not to be integrated
  /// (first frame, clock not ahead, gap longer than Options::max_gap_s).
  S advance(Timestamp t) noexcept {
    const double span_s = has_time_ ? seconds_between(t_, t) : 0.0;
    const S elapsed_s = static_cast<S>(span_s > 0 ? span_s : 0);
    const bool integrated = span_s > 0 && span_s <= options_.max_gap_s;
    t_ = t, has_time_ = true;
    if (integrated && !rates_.isZero(0)) {  // at rest q keeps its bits
      const Rates step = rates_ * elapsed_s;
      q_ = within_limits(model::integrate<M, S>(q_, step));
    } else {
      rates_.setZero();
    }
    const Rates growth =
        spread(options_.growth_base_m, options_.growth_base_rad, options_.growth_slide_m, options_.growth_turn_rad);
    deviation_ = (deviation_ + growth * elapsed_s).cwiseMin(most());
    return integrated ? elapsed_s : S(0);
  }

  /// A frame has been measured at the prior's time. `continuous` when the one before it was, too. A degree of freedom
  /// that the frame says nothing of (see is_weak) is taken to stand still: nothing would stop it from running away.
  void measured(const Configuration& q, const Mat<S, kDof, kDof>& covariance, S span_s, bool continuous) noexcept {
    if (continuous && span_s > S(0)) {
      const Rates surprise = model::difference(q_, q) / span_s;  // velocity beyond the predicted one
      rates_ += S(kRateGain) * surprise;
    } else {
      rates_.setZero();
    }
    for (int i = 0; i < kDof; ++i) {
      if (is_weak(covariance, i)) rates_[i] = S(0);
    }
    q_ = q;
    for (int i = 0; i < kDof; ++i) deviation_[i] = std::sqrt(covariance(i, i));
  }

  /// Half the prior's deviation is left: the frame has said less of this degree of freedom than was known without it.
  bool is_weak(const Mat<S, kDof, kDof>& covariance, int i) const noexcept {
    return !(covariance(i, i) < S(0.25) * prior_variance()[i]);
  }
  /// All of it is left, but for a hundredth: what the neighbours' correlations take is no observation.
  Observability observability(const Mat<S, kDof, kDof>& covariance, int i) const noexcept {
    if (!is_weak(covariance, i)) return Observability::observed;
    return covariance(i, i) < S(0.98) * prior_variance()[i] ? Observability::weak : Observability::held;
  }

  /// The object was found at q, whatever was expected.
  void restart(const Configuration& q) noexcept {
    q_ = q;
    deviation_ = most();
    rates_.setZero();
  }

  /// Nothing is known of the motion any more: the mean stays where it is.
  void halt() noexcept { rates_.setZero(); }

  const Configuration& q() const noexcept { return q_; }
  const Rates& rates() const noexcept { return rates_; }
  Prior<M, S> prior() const noexcept { return {q_, prior_variance()}; }

  /// How far q may be from the truth, m^2 and rad^2.
  Rates variance() const noexcept { return deviation_.cwiseAbs2(); }

  /// Takes back all that is known of how near the mean is: as wide as before anything was seen.
  void widen() noexcept { deviation_ = most(); }

 private:
  /// Share of a velocity surprise that is believed: the noise of a difference of two frames is damped to a third while
  /// a change of speed is followed within five frames. Only windows and starting points depend on it.
  static constexpr double kRateGain = 0.4;

  static Rates spread(double base_m, double base_rad, double slide_m, double turn_rad) noexcept {
    Rates spread;
    spread.template head<3>().setConstant(static_cast<S>(base_m));
    spread.template segment<3>(3).setConstant(static_cast<S>(base_rad));
    for (int j = 0; j < model::kNumJoints<M>; ++j) {
      const bool slides = model::kValueRows<M>[static_cast<std::size_t>(j)].kind == model::JointKind::prismatic;
      spread[6 + j] = static_cast<S>(slides ? slide_m : turn_rad);
    }
    return spread;
  }

  Rates prior_variance() const noexcept { return deviation_.cwiseMax(least()).cwiseAbs2(); }
  Rates least() const noexcept {
    return spread(options_.prior_base_m, options_.prior_base_rad, options_.prior_slide_m, options_.prior_turn_rad);
  }
  Rates most() const noexcept {
    return spread(options_.start_base_m, options_.start_base_rad, options_.start_slide_m, options_.start_turn_rad);
  }

  /// A prediction does not carry a joint beyond its limits.
  static Configuration within_limits(Configuration q) noexcept {
    for (int j = 0; j < model::kNumJoints<M>; ++j) {
      const auto& row = model::kValueRows<M>[static_cast<std::size_t>(j)];
      const S low = static_cast<S>(row.q_min), high = static_cast<S>(row.q_max);
      q.joints[j] = q.joints[j] < low ? low : (q.joints[j] > high ? high : q.joints[j]);
    }
    return q;
  }

  Options options_;
  Configuration q_{};
  Rates deviation_ = Rates::Ones();
  Rates rates_ = Rates::Zero();
  Timestamp t_{};
  bool has_time_{false};
};

}  // namespace articam::tracker
