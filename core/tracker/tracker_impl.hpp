#pragma once
/// @file  The steps behind the front door, tracker.hpp.

#include "core/tracker/tracker.hpp"

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
    : options_{options}, camera_{camera}, detector_{detector_options<Model>()}, judge_{options}, motion_{options} {
  if constexpr (Model::kHasQ0) {
    if (const auto q0 = model::from_numbers<Model, Scalar>(Model::kQ0); q0.ok()) set_start(q0.value());
  }
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::set_start(const Configuration& q0) noexcept {
  motion_.start(q0);
  paper_.reset();
  judge_ = Judge{options_};
  previous_matches_ = {};
  noise_scale_ = Scalar(1), frames_in_scale_ = 0;
  has_start_ = true;
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::step(const ImageView& image, Timestamp t) noexcept -> EstimateType {
  begin(t);  // prior at time t
  if (!has_start_ || !fits(image)) return judge(evidence_, t);
  look(image);                                                              // image      -> detections
  match(judge_.following() ? kTrackingGate<Scalar> : kSearchGate<Scalar>);  // detections -> pairs (s, s_star)
  if (options_.mode == Mode::paper) {
    paper_step();  // pairs -> e, A -> (5) -> (6)
  } else if (judge_.following()) {
    iterate(motion_.prior());  // pairs -> e, A -> steps to convergence
  } else {
    search();  // the same, pairing anew as q improves
  }
  weigh();  // how well does it fit
  return judge(evidence_, t);
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::coast(Timestamp t) noexcept -> EstimateType {
  // The next frame may have been exposed before t: what is given out here leaves the tracker's own time alone.
  const MotionPrior<Model, Scalar> motion = motion_;
  begin(t);
  evidence_.has_frame = false;
  const EstimateType estimate = judge(evidence_, t);
  motion_ = motion;
  return estimate;
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::begin(Timestamp t) noexcept {
  previous_matches_ = matches_;
  matches_ = {};
  detections_.clear();
  found_ = {};
  evidence_ = {.has_start = has_start_};
  period_s_ = motion_.advance(t);
  q_ = motion_.q();
}

template <class Model, class Scalar>
bool Tracker<Model, Scalar>::fits(const ImageView& image) noexcept {
  const CameraParameters& camera = camera_.parameters();
  evidence_.frame_fits = image.ok() && image.width_px == camera.width_px && image.height_px == camera.height_px;
  return evidence_.frame_fits;
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::look(const ImageView& image) noexcept {
  Status seen = Status::ok;
  if (judge_.following()) {
    features_ = predict_features<Model, Scalar>(q_, camera_);
    FixedVector<PixelBox, static_cast<std::size_t>(model::kNumMarkers<Model>)> windows;
    for (const Feature<Scalar>& feature : features_) {
      if (!feature.visible) continue;
      const Scalar reach = reach_px(feature, kTrackingGate<Scalar>) + Scalar(1.3) * feature.radius_px + Scalar(3);
      (void)windows.push_back({static_cast<int>(feature.pixel.x() - reach), static_cast<int>(feature.pixel.y() - reach),
                               static_cast<int>(feature.pixel.x() + reach),
                               static_cast<int>(feature.pixel.y() + reach)});
    }
    seen = detector_.detect(image, std::span<const PixelBox>(windows.begin(), windows.size()), detections_);
  } else {
    seen = detector_.detect(image, detections_);
  }
  evidence_.frame_fits = seen == Status::ok;
  evidence_.overloaded = detector_.overloaded();
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::match(const Gate<Scalar>& gate) noexcept {
  features_ = predict_features<Model, Scalar>(q_, camera_);
  matches_ = associate<Model, Scalar>(features_, detections_, camera_, gate, static_cast<Scalar>(options_.floor_px));
  for (auto& match : matches_) match.variance *= noise_scale_;
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::iterate(const Prior<Model, Scalar>& prior) noexcept {
  found_ = solve_with_consensus<Model, Scalar>(matches_, prior, q_, kConsistent, kMaxIterations);
  if (found_.solution.status == Status::ok) q_ = found_.solution.q;
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::search() noexcept {
  const auto prior = motion_.wide_prior();
  found_.solution = solve(matches_, prior, q_, kMaxIterations);
  for (int round = 1; round < kSearchRounds && found_.solution.status == Status::ok; ++round) {
    q_ = found_.solution.q;
    match(round + 1 < kSearchRounds ? kSearchGate<Scalar> : kTrackingGate<Scalar>);
    if (round + 1 < kSearchRounds) {
      found_.solution = solve(matches_, prior, q_, kMaxIterations);
    } else {
      iterate(prior);
    }
  }
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::paper_step() noexcept {
  System<Model, Scalar> system;
  found_.solution.status = stack(matches_, q_, FeatureKind::point, system);
  if (found_.solution.status != Status::ok || count<Model, Scalar>(matches_) == 0) return;
  found_.solution.error_norm = system.e.norm();
  found_.solution.iterations = 1;

  Vec<Scalar, System<Model, Scalar>::kRows> s_star_dot = Vec<Scalar, System<Model, Scalar>::kRows>::Zero();
  if (options_.feed_forward && period_s_ > Scalar(0)) {
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      if (!matches_[i].matched || !previous_matches_[i].matched) continue;
      s_star_dot.template segment<2>(static_cast<Eigen::Index>(2 * i)) =
          (matches_[i].s_star - previous_matches_[i].s_star) / period_s_;
    }
  }
  qdot_ = control_law(system, gain(options_.gain, found_.solution.error_norm), s_star_dot);
  const auto normal = normal_equations(system, Vec<Scalar, kDof>(Vec<Scalar, kDof>::Zero()), motion_.prior().variance);
  math::Cholesky<Scalar, kDof> cholesky;
  found_.solution.status = cholesky.factorise(normal.H);
  if (found_.solution.status == Status::ok) found_.solution.covariance = cholesky.inverse();
  q_ = paper_.integrate(q_, qdot_, period_s_);
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::weigh() noexcept {
  Solution<Model, Scalar>& solution = found_.solution;
  evidence_.matched = count<Model, Scalar>(matches_);
  evidence_.redundant = 2 * evidence_.matched > kDof;
  evidence_.outlier = found_.outlier >= 0;
  if (solution.status != Status::ok || evidence_.matched == 0) return;
  rms_px_ = rms_px();
  const bool paper = options_.mode == Mode::paper;
  evidence_.agrees = rms_px_ <= static_cast<Scalar>(paper ? kPaperMaxRms_px : options_.max_rms_px);
  evidence_.converged = paper ? evidence_.agrees : solution.converged;
  const auto prior = judge_.following() || paper ? motion_.prior() : motion_.wide_prior();
  for (int i = 0; i < kDof; ++i) {
    // Half the prior's deviation left: the frame has said less of this degree of freedom than was known without it.
    if (!(solution.covariance(i, i) < Scalar(0.25) * prior.variance[i])) evidence_.weak = true;
  }
  if (paper || !evidence_.redundant || evidence_.outlier || !evidence_.agrees) return;
  // A running mean over many frames: one frame's few spare equations cannot give the scale.
  frames_in_scale_ = frames_in_scale_ < kScaleFrames ? frames_in_scale_ + 1 : kScaleFrames;
  const Scalar spare = static_cast<Scalar>(2 * evidence_.matched - kDof);
  const Scalar measured = noise_scale_ * solution.chi2 / spare;
  noise_scale_ += (measured - noise_scale_) / static_cast<Scalar>(frames_in_scale_ + 1);
  if (!(noise_scale_ >= Scalar(1))) noise_scale_ = Scalar(1);  // never surer than the detector
}

template <class Model, class Scalar>
auto Tracker<Model, Scalar>::judge(const Evidence& evidence, Timestamp t) noexcept -> EstimateType {
  const bool continuous = judge_.following();
  const Verdict verdict = judge_.decide(evidence, t);
  EstimateType estimate;
  estimate.t_capture = t;
  estimate.status = verdict.status;
  estimate.reason = verdict.reason;
  estimate.matched = evidence.matched;
  estimate.rms_px = evidence.matched > 0 ? rms_px_ : Scalar(0);
  estimate.error_norm = found_.solution.error_norm;
  estimate.iterations = found_.solution.iterations;
  const bool paper = options_.mode == Mode::paper;
  const bool good = verdict.status == TrackingStatus::tracking || verdict.status == TrackingStatus::degraded;
  const bool moved = good || (paper && found_.solution.iterations > 0 && found_.solution.status == Status::ok);
  if (moved) {
    motion_.measured(q_, found_.solution.covariance, period_s_, continuous && !paper);
    estimate.covariance = found_.solution.covariance;
  } else {
    estimate.covariance = motion_.prior().variance.asDiagonal();
    if (verdict.status != TrackingStatus::coasting) motion_.halt();  // a lost object is not followed into the blue
  }
  if (!paper) qdot_ = motion_.rates();
  estimate.q = motion_.q();
  estimate.qdot = qdot_;
  estimate.valid = moved || verdict.status == TrackingStatus::coasting;
  return estimate;
}

/// Root mean square of the matched features' 2-D distances, in pixels, lens distortion included.
template <class Model, class Scalar>
Scalar Tracker<Model, Scalar>::rms_px() const noexcept {
  const auto features = predict_features<Model, Scalar>(q_, camera_);
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
