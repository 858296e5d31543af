#pragma once
/// @file  Between two frames: where the object is expected, how surely, and how fast it moves.

#include "core/timestamp.hpp"
#include "core/tracker/motion_filter.hpp"
#include "core/tracker/options.hpp"
#include "core/tracker/vvs.hpp"

namespace articam::tracker {

/// The options' number for each degree of freedom.
template <class M, class S>
Vec<S, model::kDof<M>> per_freedom(const PerFreedom& sorts) noexcept {
  Vec<S, model::kDof<M>> each;
  for (int i = 0; i < 6; ++i) each[i] = static_cast<S>(i < 3 ? sorts.base_m : sorts.base_rad);
  for (int j = 0; j < model::kNumJoints<M>; ++j) {
    const bool slides = model::kValueRows<M>[static_cast<std::size_t>(j)].kind == model::JointKind::prismatic;
    each[6 + j] = static_cast<S>(slides ? sorts.slide_m : sorts.turn_rad);
  }
  return each;
}

/// The motion filter with a clock and with bounds: time that stands or leaps, what is forgotten, joint limits.
template <class M, class S>
class MotionPrior {
 public:
  static constexpr int kDof = model::kDof<M>;
  using Rates = Vec<S, kDof>;
  using Square = Mat<S, kDof, kDof>;
  using Configuration = model::Configuration<M, S>;

  explicit MotionPrior(const Options& options) noexcept
      : max_gap_s_{options.max_gap_s},
        density_{squared(per_freedom<M, S>(options.acceleration))},
        most_{squared(per_freedom<M, S>(options.start))},
        most_rate_{squared(per_freedom<M, S>(options.start_rate))} {
    restart({});
  }

  void start(const Configuration& q0) noexcept {
    restart(q0);
    motion_.q = q0;
    has_time_ = false;
  }

  /// Moves the prior to time t. Returns the span since the last frame, s; 0 where it is not to be integrated (first
  /// frame, clock not ahead, gap longer than Options::max_gap_s): the rates are then forgotten, and after such a gap
  /// how near the mean is, too.
  S advance(Timestamp t) noexcept {
    const double span_s = has_time_ ? seconds_between(t_, t) : 0.0;
    const bool integrated = span_s > 0 && span_s <= max_gap_s_;
    t_ = t, has_time_ = true;
    if (integrated) {
      tracker::advance<M, S>(motion_, static_cast<S>(span_s), density_);
      hold_limits();
      forget_what_is_lost();
    } else {
      halt();
      if (span_s > 0) widen();
    }
    return integrated ? static_cast<S>(span_s) : S(0);
  }

  /// A frame has been measured at the prior's time, solved with prior(). `continuous` when the one before it was, too.
  void measured(const Configuration& q, const Square& covariance, bool continuous) noexcept {
    Square information;
    if (continuous && math::invert(motion_.P_qq, information) == Status::ok) {
      correct<M, S>(motion_, information, q, covariance);
    } else {
      halt();
      motion_.q = q, motion_.P_qq = covariance;
    }
  }

  /// The object was found at q, whatever was expected. Of the two quaternions of its pose that nearer to the last one.
  void restart(const Configuration& q) noexcept {
    const bool far = motion_.q.T_cam_obj.R.dot(q.T_cam_obj.R) < S(0);
    motion_.q = q;
    if (far) motion_.q.T_cam_obj.R.coeffs() = -q.T_cam_obj.R.coeffs();
    halt();
    widen();
  }

  /// Nothing is known of the rates any more: the mean stays where it is.
  void halt() noexcept {
    motion_.qdot = math::zeros<Rates>();
    motion_.P_vq = motion_.P_vv = math::zeros<Square>();
    for (int i = 0; i < kDof; ++i) motion_.P_vv(i, i) = most_rate_[i];
  }

  /// Takes back all that is known of how near the mean is: as wide as before anything was seen.
  void widen() noexcept {
    motion_.P_qq = motion_.P_vq = math::zeros<Square>();
    for (int i = 0; i < kDof; ++i) motion_.P_qq(i, i) = most_[i];
  }

  /// The rates that belong to a configuration q at the prior's time, `prior` being prior().
  Rates rates_given(const Configuration& q, const Prior<M, S>& prior) const noexcept {
    return motion_.qdot + motion_.P_vq.lazyProduct(prior.information.lazyProduct(model::difference(motion_.q, q)));
  }

  const Configuration& q() const noexcept { return motion_.q; }
  const Rates& rates() const noexcept { return motion_.qdot; }
  const Square& covariance() const noexcept { return motion_.P_qq; }
  const Motion<M, S>& motion() const noexcept { return motion_; }

  /// Without information where the covariance cannot be inverted: the frame then stands alone.
  Prior<M, S> prior() const noexcept {
    Prior<M, S> prior{.mean = motion_.q};
    (void)math::invert(motion_.P_qq, prior.information);
    return prior;
  }

 private:
  static Rates squared(Rates x) noexcept {
    for (int i = 0; i < kDof; ++i) x[i] *= x[i];
    return x;
  }

  /// A degree of freedom that nothing has held for long is no better known than at the start.
  void forget_what_is_lost() noexcept {
    for (int i = 0; i < kDof; ++i) {
      if (motion_.P_qq(i, i) < most_[i]) continue;
      for (int j = 0; j < kDof; ++j) {
        motion_.P_qq(i, j) = motion_.P_qq(j, i) = motion_.P_vv(i, j) = motion_.P_vv(j, i) = S(0);
        motion_.P_vq(i, j) = motion_.P_vq(j, i) = S(0);
      }
      motion_.P_qq(i, i) = most_[i], motion_.P_vv(i, i) = most_rate_[i], motion_.qdot[i] = S(0);
    }
  }

  /// A prediction does not carry a joint beyond its limits. Where one was seen to be beyond, it is known no better than
  /// by how far.
  void hold_limits() noexcept {
    const auto joints = model::within_limits<M, S>(motion_.q.joints);
    for (int j = 0; j < model::kNumJoints<M>; ++j) {
      const S beyond = motion_.q.joints[j] - joints[j];
      if (beyond == S(0)) continue;
      motion_.q.joints[j] = joints[j];
      motion_.qdot[6 + j] = S(0);
      motion_.P_qq(6 + j, 6 + j) += beyond * beyond;
    }
  }

  double max_gap_s_;
  Rates density_, most_, most_rate_;  // variances
  Motion<M, S> motion_{};
  Timestamp t_{};
  bool has_time_{false};
};

}  // namespace articam::tracker
