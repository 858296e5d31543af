#pragma once
/// @file  What a search keeps, when it gives up, and what it concludes: acquire.hpp.

#include "core/tracker/acquire.hpp"

namespace articam::tracker {

/// The most that a hypothesis may cost to be looked at: in the first pass, what marks beyond the model's cost, or
/// markers short of it, and no pair's worth more.
template <class M, class S>
S Acquisition<M, S>::limit() const noexcept {
  if (next_.pass > 0) return std::numeric_limits<S>::max();
  const int surplus = static_cast<int>(sightings_.size()) - model::kNumMarkers<M>;
  return kPrice<S> * static_cast<S>(surplus > 0 ? surplus + 2 : 2) - S(1);
}

/// Whether a trial began with the anchor's markers within a radius of where q has them.
template <class M, class S>
bool Acquisition<M, S>::was_tried(const Configuration& q, int anchor) const noexcept {
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  for (std::size_t k = 0; k < num_trials_ && k < kMaxTrials; ++k) {
    if (trials_[k].anchor != anchor) continue;
    bool same = true;
    for (std::size_t m = 0; same && m < M::kMarkers.size(); ++m) {
      if (M::kMarkers[m].body != anchor) continue;
      const Vec<S, 3> before = trials_[k].T_cam_anchor * model::detail::to_vec<S>(M::kMarkers[m].t_body_m);
      const S radius_m = static_cast<S>(0.5 * M::kMarkers[m].outer_diameter_m);
      same = (q.T_cam_obj * kinematics.markers[m].centre - before).squaredNorm() < radius_m * radius_m;
    }
    if (same) return true;
  }
  return false;
}

template <class M, class S>
void Acquisition<M, S>::remember(const Configuration& q, int anchor) noexcept {
  Pose<S> T_cam_anchor = q.T_cam_obj;
  if constexpr (model::kNumBodies < M >> 0) {
    const auto kinematics = model::forward_kinematics<M, S>(q.joints);
    if (anchor >= 0) T_cam_anchor = T_cam_anchor * kinematics.T_obj_body[static_cast<std::size_t>(anchor)];
  }
  trials_[num_trials_++ % kMaxTrials] = {anchor, T_cam_anchor};
}

template <class M, class S>
bool Acquisition<M, S>::is_hopeless(S least) const noexcept {
  return least > limit() || (!result_.candidates.empty() && least > result_.candidates[0].cost + kMargin);
}

/// Keeps the two cheapest distinct hypotheses, in order.
template <class M, class S>
void Acquisition<M, S>::record(const Hypothesis<M, S>& hypothesis) noexcept {
  auto& kept = result_.candidates;
  if (hypothesis.paired < 2 || is_hopeless(hypothesis.cost)) return;
  for (Hypothesis<M, S>& other : kept) {
    if (is_distinct(other, hypothesis)) continue;
    if (hypothesis.cost < other.cost) {
      const bool challenged = other.challenged;
      other = hypothesis;
      other.challenged = challenged;
    }
    if (kept.size() == 2 && kept[1].cost < kept[0].cost) std::swap(kept[0], kept[1]);
    return;
  }
  if (!kept.push_back(hypothesis)) {
    if (!(hypothesis.cost < kept[1].cost)) return;
    kept[1] = hypothesis;
  }
  if (kept.size() == 2 && kept[1].cost < kept[0].cost) std::swap(kept[0], kept[1]);
}

/// More equations than the paired markers' unknowns, and pairs that agree. A box never shows all its faces: where the
/// pairs alone give three times as many equations as there are unknowns, they vouch for the rest.
template <class M, class S>
bool Acquisition<M, S>::is_credible(const Hypothesis<M, S>& hypothesis) const noexcept {
  JointSet joints = 0;
  int first = -1;
  for (std::size_t m = 0; m < hypothesis.sighting.size(); ++m) {
    if (hypothesis.sighting[m] < 0) continue;
    if (first < 0) first = static_cast<int>(m);
    joints |= joints_between<M>(M::kMarkers[static_cast<std::size_t>(first)].body, M::kMarkers[m].body);
  }
  const int equations = 2 * hypothesis.paired, unknowns = 6 + std::popcount(joints);
  const bool ample = hypothesis.paired == model::kNumMarkers<M> || equations >= 3 * unknowns;
  return equations > unknowns && is_determined(hypothesis) &&
         hypothesis.misfit <= (ample ? kMaxMisfit : kMaxMisfitOfPart) * static_cast<S>(hypothesis.paired);
}

template <class M, class S>
void Acquisition<M, S>::conclude() noexcept {
  const auto& found = result_.candidates;
  const bool rivalled = found.size() == 2 && found[1].cost < found[0].cost + kMargin;
  if (!result_.complete && sightings_.size() >= 2) {
    result_.reason = Reason::not_converged;
  } else if (found.empty() || !is_credible(found[0])) {
    const bool misfits = !found.empty() && is_determined(found[0]);
    result_.reason = misfits ? Reason::large_residual : Reason::few_markers;
  } else {
    result_.certainty = rivalled ? Certainty::ambiguous : Certainty::sure;
    result_.reason = rivalled ? Reason::ambiguous : Reason::none;
  }
}

}  // namespace articam::tracker
