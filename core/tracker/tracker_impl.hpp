#pragma once
/// @file  The steps behind the front door, tracker.hpp.

#include <algorithm>

#include "core/tracker/look.hpp"
#include "core/tracker/observed.hpp"
#include "core/tracker/rolling_shutter.hpp"
#include "core/tracker/tracker.hpp"
#include "core/tracker/tracker_search.hpp"

namespace articam::tracker {

/// What the detector has to look for, from the model's table.
template <class Model>
constexpr vision::DetectorOptions detector_options() noexcept {
  vision::DetectorOptions options{.rings = false};
  for (const model::MarkerRow& row : Model::kMarkers) {
    switch (row.kind) {
      case model::MarkerKind::ring:
        options.rings = true;
        options.ring_ratio_q16 = static_cast<std::int32_t>(65536.0 * row.inner_diameter_m / row.outer_diameter_m + 0.5);
        break;
      case model::MarkerKind::dot_light_on_dark:
        options.dots_light_on_dark = true;
        break;
      case model::MarkerKind::dot_dark_on_light:
        options.dots_dark_on_light = true;
        break;
      case model::MarkerKind::point:
        break;
    }
  }
  return options;
}

template <class Model, class Scalar>
Tracker<Model, Scalar>::Tracker(const CameraParameters& camera, const Options& options) noexcept
    : options_{options},
      camera_{camera},
      detector_{detector_options<Model>()},
      coarse_{per_freedom<Model, Scalar>(options.coarse).cwiseAbs2()},
      judge_{options, false},
      motion_{options},
      acquisition_{camera_, static_cast<Scalar>(options.floor_px)} {
  static_assert(detector_options<Model>().ok(), "the rings' inner : outer diameter is out of the detector's range");
  if constexpr (Model::kHasQ0) {
    if (const auto q0 = model::from_numbers<Model, Scalar>(Model::kQ0); q0.ok()) set_start(q0.value());
  }
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::set_start(const Configuration& q0) noexcept {
  motion_.start(q0);
  paper_.reset();
  judge_ = Judge{options_, true};
  acquisition_.reset();
  noise_ = {}, shape_noise_ = {};
  matches_ = {};
  newest_ = {};
  rival_ = {};
  has_start_ = true;
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::step(const ImageView& image, Timestamp t) noexcept -> EstimateType {
  if (const Reason reason = refusal(t); reason != Reason::none) return coast(t, reason);
  if (!fits(image)) return coast(t, Reason::image_mismatch);
  begin(t);     // prior at time t
  look(image);  // image      -> detections
  return follow(t);
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::step(const vision::Detections& detections, bool overloaded, Timestamp t) noexcept
    -> EstimateType {
  if (const Reason reason = refusal(t); reason != Reason::none) return coast(t, reason);
  begin(t);
  detections_ = detections;
  evidence_.overloaded = overloaded;
  return follow(t);
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::follow(Timestamp t) noexcept -> EstimateType {
  const bool paper = options_.mode == Mode::paper;
  if (has_start_) {
    match();  // detections -> pairs (s, s_star)
    if (paper) {
      paper_step();  // pairs -> e, A -> (5) -> (6)
    } else if (following_) {
      iterate();  // pairs -> e, A -> steps to convergence
      doubt();    // is its mirror image as good?
    } else {
      search();  // the same, pairing anew as q improves
    }
    weigh();  // how well does it fit
  }
  if (!following_ && !paper) acquire();  // detections -> q without a prediction
  if (!paper && evidence_.agrees && evidence_.converged && !evidence_.outlier) learn_noise();
  return judge(t);
}

/// What is wrong with a frame before a pixel of it is read.
template <class Model, class Scalar>
Reason Tracker<Model, Scalar>::refusal(Timestamp t) const noexcept {
  if (!has_start_ && options_.mode == Mode::paper) return Reason::no_start;
  return any_frame_ && t <= t_frame_ ? Reason::stale_frame : Reason::none;
}

template <class Model, class Scalar>
bool Tracker<Model, Scalar>::fits(const ImageView& image) const noexcept {
  const CameraParameters& camera = camera_.parameters();
  return image.ok() && image.width_px == camera.width_px && image.height_px == camera.height_px;
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::coast(Timestamp t, Reason reason) const noexcept -> EstimateType {
  MotionPrior<Model, Scalar> motion = motion_;
  const bool following = judge_.following(t);
  if (!following) motion.halt();  // not into the blue
  (void)motion.advance(t);
  if (!following) motion.widen();
  Verdict verdict = judge_.unmeasured(reason, t);
  if (!has_start_ && options_.mode == Mode::paper) verdict = {TrackingStatus::initialising, Reason::no_start};
  if (reason == Reason::image_mismatch && !following) verdict.status = TrackingStatus::fault;
  EstimateType estimate;
  estimate.t_capture = estimate.t = t;
  estimate.status = verdict.status;
  estimate.reason = verdict.reason;
  estimate.valid = verdict.status == TrackingStatus::coasting;
  estimate.q = motion.q();
  estimate.qdot = motion.rates();
  estimate.covariance = motion.covariance();
  return estimate;
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::predict(Timestamp t) const noexcept -> EstimateType {
  if (t <= newest_.t) return newest_;
  if (!newest_.valid || !judge_.following(t)) return coast(t);
  MotionPrior<Model, Scalar> motion = motion_;
  (void)motion.advance(t);
  EstimateType estimate = newest_;
  estimate.t = t;
  estimate.q = motion.q();
  estimate.qdot = motion.rates();
  estimate.covariance = motion.covariance();
  return estimate;
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::begin(Timestamp t) noexcept {
  any_frame_ = true, t_frame_ = t;
  previous_matches_ = matches_;
  matches_ = {};
  detections_.clear();
  found_ = {};
  evidence_ = {};
  rms_px_ = Scalar(0);
  following_ = judge_.following(t);
  period_s_ = motion_.advance(t);
  if (!following_) motion_.widen();
  q_ = motion_.q();
  expect(motion_.covariance());
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::expect(const Mat<Scalar, kDof, kDof>& P) noexcept {
  features_ = predict_features<Model, Scalar>(q_, camera_, feature_kind());
  spread_features<Model, Scalar>(q_, camera_, P, features_);
  if (!is_rolling(camera_.parameters())) return;
  set_rates<Model, Scalar>(q_, motion_.rates(), features_);
  delay_features<Model, Scalar>(camera_, features_);
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::look(const ImageView& image) noexcept {
  if (following_) {
    evidence_.overloaded = tracker::look<Model, Scalar>(detector_, image, features_, detections_);
  } else {
    (void)detector_.detect(image, detections_);  // the view was checked by fits()
    evidence_.overloaded = detector_.overloaded();
  }
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::match() noexcept {
  matches_ = associate<Model, Scalar>(features_, detections_, camera_, static_cast<Scalar>(options_.floor_px));
  for (auto& match : matches_) match.variance *= noise_.factor(), match.shape_variance *= shape_noise_.factor();
  if (is_rolling(camera_.parameters())) undo_delays();
  measured_ = matches_;
}

/// Each round the rates that the last one's solution implies; what is left of a wrong rate falls to a third.
template <class Model, class Scalar>
void Tracker<Model, Scalar>::undo_delays() noexcept {
  constexpr int kRounds = 4;
  const Matches<Model, Scalar> shown = matches_;
  const Prior<Model, Scalar> prior = motion_.prior();
  Configuration q = q_;
  for (int round = 0;; ++round) {
    set_rates<Model, Scalar>(q, motion_.rates_given(q, prior), features_);
    matches_ = without_delay<Model, Scalar>(camera_, features_, shown);
    if (round == kRounds || !following_) return;
    const Solution<Model, Scalar> solution = solve(matches_, prior, q, 1);
    if (solution.status != Status::ok) return;
    q = solution.q;
  }
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::iterate() noexcept {
  found_ = solve_with_consensus<Model, Scalar>(matches_, motion_.prior(), q_, kMaxIterations);
  if (found_.solution.status == Status::ok) q_ = found_.solution.q;
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::doubt() noexcept {
  if (found_.solution.status != Status::ok) return;
  if (!rival_.challenge(matches_, found_)) return;
  motion_.restart(found_.solution.q);
  q_ = motion_.q();
}

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

template <class Model, class Scalar>
void Tracker<Model, Scalar>::weigh() noexcept {
  const Solution<Model, Scalar>& solution = found_.solution;
  evidence_.matched = count<Model, Scalar>(matches_);
  evidence_.complete = evidence_.matched == model::kNumMarkers<Model>;
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
  const Normal<Model, Scalar> by_centres = linearise(centres, q_),
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
