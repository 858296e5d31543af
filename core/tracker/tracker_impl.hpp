#pragma once
/// @file  The steps behind the front door, tracker.hpp.

#include <algorithm>

#include "core/tracker/look.hpp"
#include "core/tracker/rolling_shutter.hpp"
#include "core/tracker/tracker.hpp"
#include "core/tracker/tracker_paper.hpp"
#include "core/tracker/tracker_search.hpp"
#include "core/tracker/tracker_verdict.hpp"

namespace articam::tracker {

/// What the detector has to look for, from the model's table.
template <class Model>
constexpr vision::DetectorOptions detector_options(const vision::Pinhole& camera = {}) noexcept {
  vision::DetectorOptions options{.rings = false, .camera = camera};
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

/// How well print and lens are known before frames have taught it.
inline constexpr double kUnproven_px = 0.02;

template <class Model, class Scalar>
Tracker<Model, Scalar>::Tracker(const CameraParameters& camera, const Options& options) noexcept
    : options_{options},
      camera_{camera},
      detector_{detector_options<Model>(vision::pinhole_of(camera))},
      coarse_{per_freedom<Model, Scalar>(options.coarse).cwiseAbs2()},
      judge_{options, false},
      motion_{options},
      acquisition_{camera_, static_cast<Scalar>(std::max(options.floor_px, kUnproven_px))} {
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
auto Tracker<Model, Scalar>::step(const vision::Detections& detections, const ImageReport& image, Timestamp t) noexcept
    -> EstimateType {
  if (const Reason reason = refusal(t); reason != Reason::none) return coast(t, reason);
  begin(t);
  detections_ = detections;
  evidence_.image = image;
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
    evidence_.image.overloaded = tracker::look<Model, Scalar>(detector_, image, features_, detections_);
  } else {
    (void)detector_.detect(image, detections_);  // the view was checked by fits()
    evidence_.image.overloaded = detector_.overloaded();
  }
  const auto visible = std::ranges::count_if(features_, [](const auto& feature) { return feature.visible; });
  evidence_.image.fault =
      blame_image(image, detections_, following_ ? static_cast<int>(visible) : model::kNumMarkers<Model>);
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
  if (rival_.challenge(matches_, motion_.q(), found_)) motion_.restart(found_.solution.q);
  q_ = found_.solution.q;
}

}  // namespace articam::tracker
