#pragma once
/// @file  Hand against eye: what a robot's own joints say of the object it holds, and what the camera says.

#include <cmath>
#include <cstdint>

#include "core/model/point_jacobian.hpp"
#include "core/tracker/estimate.hpp"

namespace articam::tracker {

/// How much farther a joint would stand if the hand had not lost anything on the way, and how surely that is known.
template <class S>
struct HandDifference {
  S value;     ///< m or rad, by the hand minus by the eye
  S variance;  ///< of the estimate, base pose included, and of the hand
};

/// The hand's place against that of the point it holds, along the way of a joint:
///
///     d = a^T (p_hand - p) / |a|^2,    a = dp / dq_joint,    var d = a^T (Sigma_hand I + J P J^T) a / |a|^4
///
/// held_m: the point in the frame of the body (a row of the table) that carries it. hand_m: {cam}. hand_variance: m^2.
/// Errors  bad_argument when the joint does not move the point, or when a number is not finite.
template <class M, class S>
Result<HandDifference<S>> hand_difference(const Estimate<M, S>& estimate, int joint, int body, const Vec<S, 3>& held_m,
                                          const Vec<S, 3>& hand_m, S hand_variance) noexcept {
  constexpr int kDof = model::kDof<M>;
  const auto kinematics = model::forward_kinematics<M, S>(estimate.q.joints);
  const Pose<S>& T_cam_obj = estimate.q.T_cam_obj;
  const Vec<S, 3> p_cam = T_cam_obj * (kinematics.T_obj_body[static_cast<std::size_t>(body)] * held_m);
  const Mat<S, 6, kDof> J = model::point_jacobian<M, S>(kinematics, T_cam_obj, body);
  const auto velocity = [&](int i) -> Vec<S, 3> {
    return J.template block<3, 1>(0, i) + Vec<S, 3>(J.template block<3, 1>(3, i)).cross(p_cam);
  };
  const Vec<S, 3> a = velocity(6 + joint);
  const S a2 = a.squaredNorm();
  if (!(a2 > S(1e-12)) || !math::is_finite(a2)) return Status::bad_argument;
  Vec<S, kDof> slope;  // of a^T p
  for (int i = 0; i < kDof; ++i) slope[i] = a.dot(velocity(i));
  S spread = hand_variance * a2;
  for (int i = 0; i < kDof; ++i) {
    for (int k = 0; k < kDof; ++k) spread += slope[i] * estimate.covariance(i, k) * slope[k];
  }
  const HandDifference<S> d{a.dot(hand_m - p_cam) / a2, spread / (a2 * a2)};
  if (!math::is_finite(d.value) || !(d.variance >= S(0)) || !math::is_finite(d.variance)) return Status::bad_argument;
  return d;
}

enum class SlipVerdict : std::uint8_t {
  agree,     ///< no difference beyond what is known
  differ,    ///< a difference; only a reversal can tell play from a grip that has moved
  backlash,  ///< the hand runs ahead by the same way in both directions
  slip,      ///< the grip has moved
};

/// Play and slip of a grip, from the differences while the object is being moved.
///
/// A hand with play b that pulls stands b/2 ahead of the object, pushing b/2 behind; a grip that has moved leaves the
/// same difference in both directions and, within one direction, a difference that grows. Both are only told from
/// frames in which the object moves on: while the hand crosses its play the difference means nothing.
///
/// Values are means of kSettling comparisons, but their errors are not taken to shrink by that: kinematics and camera
/// err alike for many frames. A value is significant beyond kSignificant deviations of a single comparison.
template <class S>
class SlipMonitor {
 public:
  struct Report {
    SlipVerdict verdict{SlipVerdict::agree};
    S difference{}, deviation{};  ///< of this frame, since the grasp
    S backlash{};                 ///< b; 0 until the object has moved in both directions
    S slip{};                     ///< how far the grip has moved since the object first moved
  };
  static constexpr S kSignificant{4};
  static constexpr int kSettling = 8;

  /// The hand has closed: the difference is 0 from here.
  void grasp() noexcept { *this = SlipMonitor{}; }

  /// joint: the joint's value and variance by the eye.
  Report update(const HandDifference<S>& d, S joint, S joint_variance) noexcept {
    if (zero_.n == 0) zero_variance_ = d.variance, turn_ = joint;
    if (zero_.n < kSettling && direction_ == 0) zero_.take(d.value);
    Report report;
    report.difference = d.value - zero_.value;
    report.deviation = std::sqrt(d.variance + zero_variance_);
    follow(report.difference, joint, std::sqrt(joint_variance));
    const S limit = kSignificant * report.deviation;
    const auto is_significant = [limit](S x) { return x > limit || x < -limit; };
    const Side &push = sides_[0], &pull = sides_[1];
    if (push.first.n > 0 && pull.first.n > 0) report.backlash = pull.first.value - push.first.value;
    if (direction_ != 0) report.slip = moving().slipped();
    report.verdict = is_significant(report.slip)         ? SlipVerdict::slip
                     : is_significant(report.backlash)   ? SlipVerdict::backlash
                     : is_significant(report.difference) ? SlipVerdict::differ
                                                         : SlipVerdict::agree;
    return report;
  }

 private:
  /// Of the first values, and then of about the last kSettling.
  struct Mean {
    S value{};
    int n{};
    void take(S x) noexcept {
      n = n < kSettling ? n + 1 : kSettling;
      value += (x - value) / static_cast<S>(n);
    }
  };
  /// Differences while the object moved one way.
  struct Side {
    Mean first{}, newest{};
    S slipped() const noexcept { return newest.value - first.value; }
  };

  /// A direction is that in which the object has left its turning point by more than noise.
  void follow(S difference, S joint, S joint_deviation) noexcept {
    const S least = S(1.5) * kSignificant * joint_deviation;  // both ends of a way are noisy
    const S way = joint - turn_;
    if (direction_ == 0) {
      if (way > least || way < -least)
        direction_ = way > S(0) ? 1 : -1;
      else
        return;
    } else if (way * static_cast<S>(direction_) < -least) {
      direction_ = -direction_;
    } else if (way * static_cast<S>(direction_) < least) {
      return;  // at rest: the hand may be crossing its play
    }
    turn_ = joint;
    Side &side = moving(), &other = sides_[direction_ > 0 ? 0 : 1];
    // What had slipped before the first reversal is no play.
    if (side.first.n < kSettling) side.first.take(difference - other.slipped());
    side.newest.take(difference);
  }
  Side& moving() noexcept { return sides_[direction_ > 0 ? 1 : 0]; }

  Mean zero_{};
  S zero_variance_{};
  S turn_{};         ///< the farthest value in the present direction
  int direction_{};  ///< of the object: 1, -1, 0 before it has moved
  Side sides_[2]{};
};

}  // namespace articam::tracker
