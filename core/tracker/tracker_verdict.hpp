#pragma once
/// @file  What the tracker makes of a frame's solution: evidence, lessons about the noise, the estimate. See
/// tracker.hpp.

#include <algorithm>
#include <cmath>

#include "core/tracker/observed.hpp"
#include "core/tracker/tracker.hpp"

namespace articam::tracker {

template <class Model, class Scalar>
void Tracker<Model, Scalar>::weigh() noexcept {
  const Solution<Model, Scalar>& solution = found_.solution;
  evidence_.matched = count<Model, Scalar>(matches_);
  evidence_.complete = count<Model, Scalar>(measured_) == model::kNumMarkers<Model>;
  evidence_.outlier = found_.left_out.num_marks() > 0;
  evidence_.contradictory = found_.contradictory;
  evidence_.ambiguous = rival_.stands();
  evidence_.beyond_limit = solution.beyond_limit;
  if (solution.status != Status::ok || evidence_.matched == 0) return;
  observability_ = observe<Model, Scalar>(linearise(matches_, q_, feature_kind(), solution.scale), coarse_);
  for (std::size_t i = 0; i < observability_.size(); ++i) {
    if (found_.disputed[i]) observability_[i] = std::min(observability_[i], Observability::weak);
  }
  const auto observed = static_cast<int>(std::ranges::count(observability_, Observability::observed));
  rms_px_ = rms_px();
  const bool paper = options_.mode == Mode::paper;
  evidence_.weak = observed < kDof;
  evidence_.redundant = 2 * evidence_.matched > observed;
  evidence_.agrees = rms_px_ <= static_cast<Scalar>(paper ? kPaperMaxRms_px : options_.max_rms_px);
  evidence_.converged = paper ? evidence_.agrees : solution.converged;
}

/// Compares the residuals with what they should be: equations less tr(H P), which the solution has taken up. Where it
/// was found without the shapes, its own error is in what they miss.
template <class Model, class Scalar>
void Tracker<Model, Scalar>::learn_noise() noexcept {
  const auto taken_up = [P = found_.solution.covariance](const Normal<Model, Scalar>& normal) {
    Scalar trace{0};
    for (int i = 0; i < kDof; ++i) {
      for (int j = 0; j < kDof; ++j) trace += normal.H(i, j) * P(i, j);
    }
    return trace;
  };
  Matches<Model, Scalar> centres = measured_;
  LeftOut{.shapes = true}.remove_from<Model, Scalar>(centres);
  const Normal<Model, Scalar> by_centres = linearise(centres, q_, feature_kind()),
                              by_all = linearise(measured_, q_, feature_kind(), found_.solution.scale);
  if (by_centres.status != Status::ok || by_all.status != Status::ok) return;
  const int num_centres = num_equations<Model, Scalar>(centres);
  const Scalar shapes = static_cast<Scalar>(num_equations<Model, Scalar>(measured_) - num_centres);
  const Scalar by_centres_taken = taken_up(by_centres), by_shapes_taken = taken_up(by_all) - by_centres_taken;
  noise_.learn(by_centres.chi2, static_cast<Scalar>(num_centres) - by_centres_taken);
  // Of a solution that they could mend they are no judges.
  if (by_shapes_taken < shapes)
    shape_noise_.learn(by_all.shape_chi2, found_.left_out.shapes ? shapes + by_shapes_taken : shapes - by_shapes_taken);
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::judge(Timestamp t) noexcept -> EstimateType {
  const Verdict verdict = judge_.decide(evidence_, t);
  const bool paper = options_.mode == Mode::paper;
  const bool good = verdict.status == TrackingStatus::tracking || verdict.status == TrackingStatus::degraded;
  const bool moved = good || (paper && found_.solution.iterations > 0);
  EstimateType estimate;
  estimate.t_capture = estimate.t = t;
  estimate.status = verdict.status;
  estimate.reason = verdict.reason;
  estimate.matched = evidence_.matched;
  estimate.rms_px = rms_px_;
  estimate.error_norm = found_.solution.error_norm;
  estimate.iterations = found_.solution.iterations;
  if (moved) {
    estimate.observability = observability_;
    motion_.measured(q_, found_.solution.covariance, following_ && !paper);
    estimate.covariance = found_.solution.covariance;
  } else {
    estimate.covariance = motion_.covariance();
    paper_.reset();
    // A lost object is not followed into the blue.
    if (verdict.status != TrackingStatus::coasting) motion_.halt();
  }
  estimate.q = motion_.q();
  estimate.q.joints = model::within_limits<Model, Scalar>(estimate.q.joints);
  estimate.qdot = paper && moved ? paper_rates_ : motion_.rates();
  const bool lost = verdict.status == TrackingStatus::lost || verdict.status == TrackingStatus::fault;
  estimate.valid = (moved && !lost) || verdict.status == TrackingStatus::coasting;
  newest_ = estimate;
  return estimate;
}

/// Root mean square of the matched features' 2-D distances, in pixels, lens distortion included.
template <class Model, class Scalar>
Scalar Tracker<Model, Scalar>::rms_px() const noexcept {
  const auto features = predict_features<Model, Scalar>(q_, camera_, feature_kind());
  Scalar sum{0};
  int n = 0;
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    if (!matches_[i].matched) continue;
    sum += (features[i].pixel - matches_[i].pixel).squaredNorm();
    ++n;
  }
  return n > 0 ? std::sqrt(sum / static_cast<Scalar>(n)) : Scalar(0);
}

}  // namespace articam::tracker
