#pragma once
/// @file  How the tracker finds an object that it does not follow: near a start, then anywhere. See tracker.hpp.

#include "core/tracker/tracker.hpp"

namespace articam::tracker {

template <class Model, class Scalar>
void Tracker<Model, Scalar>::search() noexcept {
  const auto kKnown = math::zeros<Mat<Scalar, kDof, kDof>>();
  Scalar first_error{0};
  int iterations = 0;
  for (int round = 0; round < kSearchRounds; ++round) {
    const bool last = round + 1 == kSearchRounds;
    if (round > 0) expect(last ? kKnown : motion_.covariance()), match();
    if (last) {
      iterate();
    } else {
      found_.solution = solve(matches_, motion_.prior(), q_, kMaxIterations);
    }
    if (round == 0) first_error = found_.solution.error_norm;
    iterations += found_.solution.iterations;
    if (found_.solution.status != Status::ok) break;
    q_ = found_.solution.q;
  }
  found_.solution.error_norm = first_error;
  found_.solution.iterations = iterations;
}

/// Whether the search from a start has done its work.
template <class Model, class Scalar>
bool Tracker<Model, Scalar>::is_found() const noexcept {
  return evidence_.redundant && evidence_.agrees && evidence_.converged && !evidence_.weak && !evidence_.contradictory;
}

template <class Model, class Scalar>
void Tracker<Model, Scalar>::acquire() noexcept {
  // Weighed against clutter: what five deviations hold is loose enough, however little is known of the noise.
  const Scalar noise = std::min(noise_.factor(), Scalar(25));
  if (is_found()) {
    const auto better = acquisition_.better_than(q_, detections_, noise);
    if (better.ok()) settle(better.value());
    return;
  }
  const Acquired<Model, Scalar>& acquired = acquisition_.search(detections_, noise);
  if (acquired.certainty == Certainty::sure) {
    settle(acquired.candidates[0].q);
  } else if (acquired.certainty == Certainty::ambiguous && has_start_) {
    settle(nearest(acquired.candidates, motion_.q()).q);
  } else if (!has_start_) {
    evidence_.unacquired = acquired.reason;
  }
}

/// The object is at q or very near: pairs anew and solves.
template <class Model, class Scalar>
void Tracker<Model, Scalar>::settle(const Configuration& q) noexcept {
  const Scalar first_error = found_.solution.error_norm;
  evidence_ = {.image = evidence_.image};
  rms_px_ = Scalar(0);
  motion_.restart(q);
  rival_ = {};
  q_ = motion_.q();
  expect(math::zeros<Mat<Scalar, kDof, kDof>>());
  match();
  iterate();
  weigh();
  if (has_start_) found_.solution.error_norm = first_error;
  has_start_ = true;
}

}  // namespace articam::tracker
