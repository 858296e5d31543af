#pragma once
/// @file  The steps of the search, acquire.hpp.

#include "core/tracker/acquire.hpp"
#include "core/tracker/acquire_record.hpp"

namespace articam::tracker {

template <class M, class S>
const Acquired<M, S>& Acquisition<M, S>::search(const vision::Detections& detections, S variance_factor) noexcept {
  variance_factor_ = variance_factor;
  sightings_ = gather<M, S>(detections, camera_, floor_px_);
  if (result_.complete) next_ = {};
  const Acquired<M, S> before = result_;
  result_ = {};
  pairs_tried_ = 0, num_trials_ = 0;
  if (!before.complete) go_on(before);
  if (sightings_.size() >= 2 && !kMarkerPairs<M>.empty()) try_pairs();
  conclude();
  return result_;
}

template <class M, class S>
auto Acquisition<M, S>::better_than(const Configuration& q, const vision::Detections& detections,
                                    S variance_factor) noexcept -> Result<Configuration> {
  reset();
  variance_factor_ = variance_factor;
  sightings_ = gather<M, S>(detections, camera_, floor_px_);
  num_trials_ = 0;
  next_.pass = 1;  // without its limit
  if (kMarkerPairs<M>.empty()) return Status::too_few_features;
  weigh(q, M::kMarkers[kMarkerPairs<M>[0].a].body, ~JointSet{0});
  if (result_.candidates.empty()) return Status::too_few_features;
  const Hypothesis<M, S> given = result_.candidates[0];
  develop(given.q, given.anchor, 0, kNoJoint);  // its joints anew: marks may have been swapped
  challenge();
  result_.complete = true;
  conclude();
  const bool better = result_.candidates[0].cost + kMargin <= given.cost;
  if (result_.certainty != Certainty::sure || !better) return Status::too_few_features;
  return result_.candidates[0].q;
}

template <class M, class S>
void Acquisition<M, S>::try_pairs() noexcept {
  while (!result_.complete && result_.work < kBudget) {
    consider();
    if (advance()) continue;
    challenge();
    const bool found = !result_.candidates.empty() && is_credible(result_.candidates[0]);
    result_.complete = next_.pass > 0 || (found && result_.candidates[0].cost + kMargin <= limit());
    next_ = {.pass = 1};
    num_trials_ = 0;  // the first pass left off where this one may go on
  }
}

/// What was found in the frame before, in this one.
template <class M, class S>
void Acquisition<M, S>::go_on(const Acquired<M, S>& before) noexcept {
  for (const Hypothesis<M, S>& hypothesis : before.candidates) {
    Configuration q = hypothesis.q;
    Pairing<M> pairing;
    if (!approach(q, hypothesis.anchor, hypothesis.known, S(3), kIterations, pairing)) continue;
    weigh(q, hypothesis.anchor, hypothesis.known);
  }
}

/// To the next hypothesis of this pass; false at its end.
template <class M, class S>
bool Acquisition<M, S>::advance() noexcept {
  const std::size_t n = sightings_.size();
  if (++next_.side < 2) return true;
  next_.side = 0;
  if (++next_.j == next_.i) ++next_.j;
  if (next_.j < n) return true;
  next_.j = 0;
  if (++next_.i < n) return true;
  next_.i = 0, next_.j = 1;
  const bool travels = kMarkerPairs<M>[next_.pair].joint >= 0;
  if (travels && ++next_.piece < travel_pieces<M>(kMarkerPairs<M>[next_.pair].joint)) return true;
  next_.piece = 0;
  if (++next_.pair >= kMarkerPairs<M>.size()) return false;
  // A rival that explains as much holds two markers fixed to each other, too: joints are tried only for want of such.
  if (kMarkerPairs<M>[next_.pair].joint < 0) return true;
  return next_.pass > 0 && (result_.candidates.empty() || !is_credible(result_.candidates[0]));
}

/// The two markers in {obj}, the joint between them where their distance is the marks'.
/// False where the marks' distance does not occur on this piece of its travel.
template <class M, class S>
bool Acquisition<M, S>::place_markers(PlacedMarker<S>& a, PlacedMarker<S>& b, Configuration& q) const noexcept {
  const MarkerPair& pair = kMarkerPairs<M>[next_.pair];
  q.joints = middle_joints<M, S>();
  const auto place = [&] {
    const auto kinematics = model::forward_kinematics<M, S>(q.joints);
    a = {kinematics.markers[pair.a], static_cast<S>(0.5 * M::kMarkers[pair.a].outer_diameter_m)};
    b = {kinematics.markers[pair.b], static_cast<S>(0.5 * M::kMarkers[pair.b].outer_diameter_m)};
    return (b.place.centre - a.place.centre).norm();
  };
  if (pair.joint < 0) {
    (void)place();
    return true;
  }
  const auto range = joint_range<M, S>(pair.joint);
  const S piece = range.length() / static_cast<S>(travel_pieces<M>(pair.joint)),
          begin = range.low + piece * static_cast<S>(next_.piece);
  q.joints[pair.joint] = begin;
  const S first = place();
  q.joints[pair.joint] = begin + piece;
  const S last = place();
  const Vec<S, 3> p = a.radius_m * sightings_[next_.i].unit_circle[0].centre;
  const Vec<S, 3> r = b.radius_m * sightings_[next_.j].unit_circle[0].centre;
  const S share = last != first ? ((r - p).norm() - first) / (last - first) : S(0.5);
  if (!(share >= S(-0.5) && share <= S(1.5))) return false;
  q.joints[pair.joint] = begin + piece * (share < S(0) ? S(0) : (share > S(1) ? S(1) : share));
  (void)place();
  return true;
}

template <class M, class S>
void Acquisition<M, S>::consider() noexcept {
  if (next_.i >= sightings_.size() || next_.j >= sightings_.size()) return;  // the frame before had more marks
  if (++pairs_tried_ % 32 == 0) ++result_.work;
  const MarkerPair& pair = kMarkerPairs<M>[next_.pair];
  const Sighting<S>&i = sightings_[next_.i], &j = sightings_[next_.j];
  if (i.kind != mark_kind(M::kMarkers[pair.a].kind) || j.kind != mark_kind(M::kMarkers[pair.b].kind)) return;
  for (const Hypothesis<M, S>& hypothesis : result_.candidates) {
    if (hypothesis.sighting[pair.a] == static_cast<int>(next_.i) &&
        hypothesis.sighting[pair.b] == static_cast<int>(next_.j)) {
      return;
    }
  }
  Configuration q;
  PlacedMarker<S> a, b;
  if (!place_markers(a, b, q)) return;
  const auto T_cam_obj = pair_pose<S>(a, b, i, next_.side, j);
  if (!T_cam_obj.ok()) return;
  q.T_cam_obj = T_cam_obj.value();
  if (was_tried(q, M::kMarkers[pair.a].body)) return;
  develop(q, M::kMarkers[pair.a].body, pair.joint < 0 ? 0 : JointSet{1} << pair.joint, kFirstGuesses);
}

/// From a pose of the anchor body to a whole configuration, joint by joint; one that its own marker does not tell of is
/// found with the next. Of joint `second_guess` the second best value is taken; a challenge (anything but
/// kFirstGuesses) does not heed what was tried: mirror images may be less than a radius apart.
template <class M, class S>
void Acquisition<M, S>::develop(Configuration q, int anchor, JointSet known, int second_guess) noexcept {
  Pairing<M> pairing;
  if (!approach(q, anchor, known, S(1.2), kFirstIterations, pairing)) return;
  if (!approach(q, anchor, known, S(0.7), kIterations, pairing)) return;
  if (second_guess == kFirstGuesses) {
    if (was_tried(q, anchor)) return;
    remember(q, anchor);
  }
  const JointSearch<M, S> joint_search(sightings_, camera_, S(1));
  JointSet tried = known;
  int blind = kNoBlindJoint;
  for (int j = next_joint(anchor, known, tried); j >= 0; j = next_joint(anchor, known, tried)) {
    tried |= JointSet{1} << j;
    if (!moves_a_centre<M>(anchor, known, j)) {  // it shows in what the next joint carries
      blind = j, known |= JointSet{1} << j;
      continue;
    }
    const auto guesses = joint_search.search(q, {anchor, known, j, blind, pairing});
    const int travels = blind == kNoBlindJoint ? 1 : kTravelPieces;
    result_.work += travels * (travel_pieces<M>(j) / 4) + static_cast<int>(guesses.size()) + 1;
    const std::size_t choice = j == second_guess ? 1 : 0;
    if (guesses.size() <= choice) {
      if (choice > 0) return;  // there is no other
      if (blind != kNoBlindJoint) known &= ~(JointSet{1} << blind);
      const bool alone = blind == kNoBlindJoint;
      blind = alone ? j : kNoBlindJoint;  // its marker is hidden: the next one's may tell of both
      if (alone) known |= JointSet{1} << j;
      continue;
    }
    if (blind != kNoBlindJoint) q = with_joint<M, S>(q, anchor, blind, guesses[choice].blind_value);
    q = with_joint<M, S>(q, anchor, j, guesses[choice].value);
    known |= JointSet{1} << j;
    blind = kNoBlindJoint;
    if (!approach(q, anchor, known, S(1), kIterations, pairing)) return;
  }
  if (approach(q, anchor, known, S(0.5), kIterations, pairing)) weigh(q, anchor, known);
}

/// The next joint that alone stands between the anchor's cluster and some marker; -1: none.
template <class M, class S>
int Acquisition<M, S>::next_joint(int anchor, JointSet known, JointSet tried) const noexcept {
  for (int j = 0; j < model::kNumJoints<M>; ++j) {
    const JointSet joint = JointSet{1} << j;
    if ((tried & joint) != 0) continue;
    for (std::size_t m = 0; m < M::kMarkers.size(); ++m) {
      if (M::kMarkers[m].kind == model::MarkerKind::point || is_placed<M>(m, anchor, known)) continue;
      if (is_placed<M>(m, anchor, known | joint)) return j;
    }
  }
  return -1;
}

/// Pairs the placed markers with marks within reach and solves for q. False when nothing is gained by going on.
template <class M, class S>
bool Acquisition<M, S>::approach(Configuration& q, int anchor, JointSet known, S reach, int iterations,
                                 Pairing<M>& pairing) noexcept {
  const auto markers = appear<M, S>(q, camera_);
  const S pixel = S(1) / camera_.focal_px();
  ++result_.work;
  if (is_hopeless(least_cost<M, S>(markers, sightings_, anchor, known, reach, pixel))) return false;
  pairing = pair_near<M, S>(markers, sightings_, anchor, known, reach, pixel);
  Matches<M, S> matches{};
  int paired = 0;
  for (std::size_t m = 0; m < pairing.size(); ++m) {
    if (pairing[m] < 0) continue;
    const Sighting<S>& seen = sightings_[static_cast<std::size_t>(pairing[m])];
    const S rough = S(0.05) * reach * markers[m].radius;  // a wrong pair must not tear the right ones apart
    matches[m] = {true, seen.detection, seen.pixel, seen.s_star, seen.variance + rough * rough};
    ++paired;
  }
  if (paired < 2) return false;
  const auto solution = solve<M, S>(matches, held_prior<M, S>(q), q, iterations);
  result_.work += solution.iterations;
  if (solution.status == Status::ok) q = solution.q;
  return solution.status == Status::ok;
}

/// Solves with the marks' own variances and records what comes of it.
template <class M, class S>
void Acquisition<M, S>::weigh(Configuration q, int anchor, JointSet known) noexcept {
  Hypothesis<M, S> hypothesis = explain<M, S>(q, appear<M, S>(q, camera_), anchor, known, sightings_, variance_factor_);
  for (int round = 0; round < 2; ++round) {
    Matches<M, S> matches{};
    for (std::size_t m = 0; m < matches.size(); ++m) {
      if (hypothesis.sighting[m] < 0) continue;
      const Sighting<S>& seen = sightings_[static_cast<std::size_t>(hypothesis.sighting[m])];
      matches[m] = {true, seen.detection, seen.pixel, seen.s_star, seen.variance * variance_factor_};
    }
    const auto solution = solve<M, S>(matches, open_prior<M, S>(q), q, kIterations);
    result_.work += solution.iterations + 1;
    if (solution.status != Status::ok) return;
    q = solution.q;
    const Pairing<M> before = hypothesis.sighting;
    hypothesis = explain<M, S>(q, appear<M, S>(q, camera_), anchor, known, sightings_, variance_factor_);
    if (hypothesis.sighting == before) break;
  }
  if (within_ranges<M, S>(q.joints)) record(hypothesis);
}

/// What else could look like the best: its mirror image, and each joint at its second best value.
template <class M, class S>
void Acquisition<M, S>::challenge() noexcept {
  for (std::size_t k = 0; k < result_.candidates.size(); ++k) {
    if (result_.candidates[k].challenged || is_hopeless(result_.candidates[k].cost)) continue;
    result_.candidates[k].challenged = true;
    const Hypothesis<M, S> hypothesis = result_.candidates[k];  // what is found may take its place
    if (const auto mirrored = mirror_image<M, S>(hypothesis); mirrored.ok()) {
      develop(mirrored.value(), hypothesis.anchor, 0, kNoJoint);
    }
    for (int j = 0; j < model::kNumJoints<M>; ++j) develop(hypothesis.q, hypothesis.anchor, 0, j);
  }
}

}  // namespace articam::tracker
