#pragma once
/// @file  Evidence of one frame -> status and reason.

#include "core/timestamp.hpp"
#include "core/tracker/estimate.hpp"
#include "core/tracker/options.hpp"

namespace articam::tracker {

/// What one frame has shown.
struct Evidence {
  bool has_start{true};   ///< there is a configuration to start from
  bool has_frame{true};   ///< the camera gave an image ...
  bool frame_fits{true};  ///< ... of the size that the camera file states
  int matched{};          ///< good matches
  bool redundant{};       ///< more equations than unknowns
  bool converged{};
  bool agrees{};  ///< residual below Options::max_rms_px
  bool weak{};    ///< some degree of freedom is held by its prior
  bool outlier{};
  bool overloaded{};
};

struct Verdict {
  TrackingStatus status{TrackingStatus::initialising};
  Reason reason{Reason::none};
};

/// Remembers what a status depends on beside the frame: what was given before, and since when nothing was measured.
class Judge {
 public:
  explicit Judge(const Options& options) noexcept : options_{options} {}

  /// True while there is a recent estimate to predict from; otherwise the whole frame is searched.
  bool following() const noexcept {
    return last_ == TrackingStatus::tracking || last_ == TrackingStatus::degraded || last_ == TrackingStatus::coasting;
  }

  Verdict decide(const Evidence& evidence, Timestamp t) noexcept {
    const Verdict verdict = consider(evidence, t);
    if (verdict.status == TrackingStatus::tracking || verdict.status == TrackingStatus::degraded) t_measured_ = t;
    last_ = verdict.status;
    return verdict;
  }

 private:
  /// Residuals too large over so many frames in a row: the model or the camera file is another object's.
  static constexpr int kMisfitsToFault = 30;

  Verdict consider(const Evidence& evidence, Timestamp t) noexcept {
    using enum TrackingStatus;
    if (!evidence.has_start) return {initialising, Reason::no_start};
    if (!evidence.has_frame) return unmeasured(Reason::no_frame, t);
    if (!evidence.frame_fits) return {fault, Reason::image_mismatch};
    misfits_ = evidence.redundant && evidence.converged && !evidence.agrees ? misfits_ + 1 : 0;
    if (misfits_ >= kMisfitsToFault) return {fault, Reason::large_residual};
    const bool enough = following() ? evidence.matched > 0 : evidence.redundant;
    if (!enough) return unmeasured(evidence.overloaded ? Reason::overload : Reason::few_markers, t);
    if (!evidence.agrees) return unmeasured(Reason::large_residual, t);
    if (!following() && !evidence.converged) return unmeasured(Reason::not_converged, t);
    if (!following() && evidence.weak) return unmeasured(Reason::few_markers, t);
    if (evidence.weak) return {degraded, Reason::weak_joint};
    if (!evidence.converged) return {degraded, Reason::not_converged};
    if (evidence.overloaded) return {degraded, Reason::overload};
    return {tracking, evidence.outlier ? Reason::outlier : Reason::none};
  }

  Verdict unmeasured(Reason reason, Timestamp t) const noexcept {
    using enum TrackingStatus;
    if (following() && seconds_between(t_measured_, t) <= options_.coast_time_s) return {coasting, reason};
    return {following() || last_ == lost || last_ == fault ? lost : initialising, reason};
  }

  Options options_;
  TrackingStatus last_{TrackingStatus::initialising};
  Timestamp t_measured_{};
  int misfits_{};
};

}  // namespace articam::tracker
