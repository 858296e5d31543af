#pragma once
/// @file  Evidence of one frame -> status and reason.

#include <algorithm>

#include "core/timestamp.hpp"
#include "core/tracker/estimate.hpp"
#include "core/tracker/image_report.hpp"
#include "core/tracker/options.hpp"

namespace articam::tracker {

/// What one frame has shown.
struct Evidence {
  int matched{};     ///< good matches
  bool complete{};   ///< to every marker of the model a mark was given
  bool redundant{};  ///< more equations than degrees of freedom that they observe
  bool converged{};
  bool agrees{};         ///< residual below Options::max_rms_px
  bool contradictory{};  ///< the matches disagree beyond their noise, and no single one is to blame
  bool weak{};           ///< some degree of freedom is held by its prior
  bool outlier{};
  bool ambiguous{};     ///< the mirror image explains the frames nearly as well
  bool beyond_limit{};  ///< the marks want a joint beyond its limit
  ImageReport image{};
  Reason unacquired{Reason::none};  ///< why a search without a prediction found nothing; none where it was not needed
};

struct Verdict {
  TrackingStatus status{TrackingStatus::initialising};
  Reason reason{Reason::none};
};

/// Remembers what a status depends on beside the frame: when the object was last measured.
class Judge {
 public:
  /// `has_start`: a prediction to begin from was given. Without one an object may take its time to come into view.
  explicit Judge(const Options& options, bool has_start = true) noexcept : options_{options}, has_start_{has_start} {}

  /// True while there is a recent estimate to predict from; otherwise the whole frame is searched.
  bool following(Timestamp t) const noexcept {
    return ever_measured_ && seconds_between(t_measured_, t) <= options_.coast_time_s;
  }

  Verdict decide(const Evidence& evidence, Timestamp t) noexcept {
    if (!any_frame_) any_frame_ = true, t_begin_ = t;
    const bool explained = evidence.agrees && evidence.redundant && !evidence.contradictory;
    const bool misfit = evidence.complete && evidence.converged && !explained;
    misfits_ = misfit ? std::min(misfits_ + 1, kMisfitsToFault) : 0;
    presses_ = evidence.beyond_limit ? std::min(presses_ + 1, kMisfitsToFault) : 0;
    Verdict verdict = consider(evidence, t);
    if (evidence.image.fault != Reason::none && is_symptom(verdict)) verdict.reason = evidence.image.fault;
    const bool good = verdict.status == TrackingStatus::tracking || verdict.status == TrackingStatus::degraded;
    // One mark in the clutter can be followed for ever; only what checks itself is a measurement.
    if (good && evidence.redundant) ever_measured_ = true, t_measured_ = t;
    return verdict;
  }

  /// The verdict where nothing was measured, whatever the reason. Changes nothing.
  Verdict unmeasured(Reason reason, Timestamp t) const noexcept {
    if (following(t)) return {TrackingStatus::coasting, reason};
    // q0 is a prediction, too: not found in the time that one is worth, the object is lost from the beginning. But the
    // paper's law comes near it by a quarter each tenth of a second, and may take as long as it takes.
    const bool in_time = !any_frame_ || seconds_between(t_begin_, t) <= options_.coast_time_s;
    const bool begins = !ever_measured_ && (in_time || !has_start_ || options_.mode == Mode::paper);
    return {begins ? TrackingStatus::initialising : TrackingStatus::lost, reason};
  }

 private:
  /// All markers seen and yet not agreeing in so many frames in a row: the model or the camera file is another's.
  /// Or a joint pressed against its limit for as long: the model has another range.
  static constexpr int kMisfitsToFault = 30;

  /// What a poor image may have caused. Two views that cannot be told apart at the start are not its doing.
  static bool is_symptom(const Verdict& verdict) noexcept {
    switch (verdict.reason) {
      case Reason::none:
      case Reason::few_markers:
      case Reason::not_converged:
      case Reason::weak_joint:
        return true;
      case Reason::ambiguous:
      case Reason::large_residual:
        return verdict.status == TrackingStatus::degraded;
      default:
        return false;
    }
  }

  Verdict consider(const Evidence& evidence, Timestamp t) const noexcept {
    using enum TrackingStatus;
    if (misfits_ >= kMisfitsToFault) return {fault, Reason::large_residual};
    if (evidence.unacquired != Reason::none) {
      return unmeasured(evidence.image.overloaded ? Reason::overload : evidence.unacquired, t);
    }
    const bool enough = following(t) ? evidence.matched > 0 : evidence.redundant;
    if (!enough) return unmeasured(evidence.image.overloaded ? Reason::overload : Reason::few_markers, t);
    if (!evidence.agrees) return unmeasured(Reason::large_residual, t);
    if (!following(t)) {
      if (!evidence.converged) return unmeasured(Reason::not_converged, t);
      if (evidence.weak) return unmeasured(Reason::few_markers, t);
    }
    if (evidence.ambiguous) return {degraded, Reason::ambiguous};
    if (evidence.weak) return {degraded, Reason::weak_joint};
    if (!evidence.redundant) return {degraded, Reason::few_markers};
    if (evidence.contradictory) return {degraded, Reason::large_residual};
    if (!evidence.converged) return {degraded, Reason::not_converged};
    if (evidence.image.overloaded) return {degraded, Reason::overload};
    // Against its stop a joint may be pressed for a moment; one that stays pressed has another range.
    if (presses_ == kMisfitsToFault) return {degraded, Reason::joint_limit};
    if (evidence.beyond_limit) return {tracking, Reason::joint_limit};
    return {tracking, evidence.outlier ? Reason::outlier : Reason::none};
  }

  Options options_;
  bool has_start_;
  bool any_frame_{false};
  Timestamp t_begin_{};
  bool ever_measured_{false};
  Timestamp t_measured_{};
  int misfits_{};
  int presses_{};  ///< frames in a row with a joint beyond its limit
};

}  // namespace articam::tracker
