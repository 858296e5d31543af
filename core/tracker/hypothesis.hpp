#pragma once
/// @file  A configuration that may explain a frame, and what speaks against it.

#include "core/tracker/appearance.hpp"
#include "core/tracker/joint_range.hpp"
#include "core/tracker/marker_pairs.hpp"

namespace articam::tracker {

/// Of every marker, the sighting that is taken for it; -1: none.
template <class M>
using Pairing = std::array<std::int8_t, static_cast<std::size_t>(model::kNumMarkers<M>)>;

/// The cost is that of all that the configuration leaves to be excused: the squared distances of paired marks in
/// deviations, of centre and shape, and kPrice for every marker that should be seen and is not, or whose joint was not
/// found, and for every mark that is no marker's. So configurations that pair different marks can be compared.
template <class M, class S>
struct Hypothesis {
  model::Configuration<M, S> q{};
  Pairing<M> sighting{};
  int anchor{-1};    ///< the body that it was begun from
  JointSet known{};  ///< the joints that it found; others stand amid their ranges
  int paired{};
  S misfit{};  ///< the part of the cost that the pairs have
  S cost{};
  bool challenged{};  ///< its mirror image and other joint values were looked at
};

/// A mark missed, or one too many: a detector that finds 99 of 100 at odds of 1 to 100 costs 9 in these units. More, to
/// bear the model's errors.
template <class S>
inline constexpr S kPrice{25};

/// Markers whose place, seen from the anchor body, depends on known joints only.
template <class M>
constexpr bool is_placed(std::size_t marker, int anchor, JointSet known) noexcept {
  return (joints_between<M>(anchor, M::kMarkers[marker].body) & ~known) == 0;
}

/// Whether a sighting could be that marker: its kind, and no farther than `reach` radii of the image (and 3 px).
/// Early poses are wrong by some degrees, and by some percent of the range: shape is held to little.
template <class M, class S>
bool is_near(std::size_t m, const Appearance<S>& marker, const Sighting<S>& seen, S reach, S pixel) noexcept {
  constexpr S kMaxShape2{1};
  if (!marker.visible || seen.kind != mark_kind(M::kMarkers[m].kind)) return false;
  const S most = reach * marker.radius + S(3) * pixel;
  return (seen.s_star - marker.s).squaredNorm() < most * most && shape_distance2(marker.shape, seen.shape) < kMaxShape2;
}

/// The best pairing of placed markers with sightings near them.
template <class M, class S>
Pairing<M> pair_near(const Appearances<M, S>& markers, const Sightings<M, S>& sightings, int anchor, JointSet known,
                     S reach, S pixel) noexcept {
  constexpr std::size_t kRows = static_cast<std::size_t>(model::kNumMarkers<M>);
  const auto cost = [&](std::size_t m, std::size_t i) -> S {
    if (!is_placed<M>(m, anchor, known) || !is_near<M>(m, markers[m], sightings[i], reach, pixel)) {
      return std::numeric_limits<S>::infinity();
    }
    const S most = reach * markers[m].radius + S(3) * pixel;
    return (sightings[i].s_star - markers[m].s).squaredNorm() / (most * most);
  };
  const auto partner = math::assign<kRows, kMaxSightings<M>>(kRows, sightings.size(), S(1), cost);
  Pairing<M> pairing;
  for (std::size_t m = 0; m < kRows; ++m) pairing[m] = static_cast<std::int8_t>(partner[m]);
  return pairing;
}

/// What speaks against q: pairs anew, by what each pair costs. A pair beyond 2 kPrice is none.
template <class M, class S>
Hypothesis<M, S> explain(const model::Configuration<M, S>& q, const Appearances<M, S>& markers, int anchor,
                         JointSet known, const Sightings<M, S>& sightings, S variance_factor) noexcept {
  constexpr std::size_t kRows = static_cast<std::size_t>(model::kNumMarkers<M>);
  constexpr S kForbidden = std::numeric_limits<S>::infinity();
  const auto cost = [&](std::size_t m, std::size_t i) -> S {
    const Sighting<S>& seen = sightings[i];
    if (!markers[m].visible || seen.kind != mark_kind(M::kMarkers[m].kind)) return kForbidden;
    const S of_centre = (seen.s_star - markers[m].s).squaredNorm() / (seen.variance * variance_factor);
    if (!(of_centre < S(2) * kPrice<S>) || !is_placed<M>(m, anchor, known)) return kForbidden;
    const S of_shape = shape_distance2(markers[m].shape, seen.shape) / seen.shape_variance;
    return of_centre + of_shape < S(2) * kPrice<S> ? of_centre + of_shape : kForbidden;
  };
  const auto partner = math::assign<kRows, kMaxSightings<M>>(kRows, sightings.size(), S(2) * kPrice<S>, cost);
  Hypothesis<M, S> hypothesis;
  hypothesis.q = q, hypothesis.anchor = anchor, hypothesis.known = known;
  for (std::size_t m = 0; m < kRows; ++m) {
    hypothesis.sighting[m] = static_cast<std::int8_t>(partner[m]);
    if (partner[m] >= 0) {
      ++hypothesis.paired;
      hypothesis.misfit += cost(m, static_cast<std::size_t>(partner[m]));
    } else if (markers[m].expected || !is_placed<M>(m, anchor, known)) {
      hypothesis.cost += kPrice<S>;
    }
  }
  const int unexplained = static_cast<int>(sightings.size()) - hypothesis.paired;
  hypothesis.cost += hypothesis.misfit + kPrice<S> * static_cast<S>(unexplained);
  return hypothesis;
}

/// The least that any configuration near this one can cost: of markers that no mark is near, and of marks that are
/// left over even if every other marker takes one.
template <class M, class S>
S least_cost(const Appearances<M, S>& markers, const Sightings<M, S>& sightings, int anchor, JointSet known, S reach,
             S pixel) noexcept {
  int missed = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (!markers[m].expected || !is_placed<M>(m, anchor, known)) continue;
    bool found = false;
    for (const Sighting<S>& seen : sightings) found = found || is_near<M>(m, markers[m], seen, reach, pixel);
    missed += found ? 0 : 1;
  }
  const int surplus = static_cast<int>(sightings.size()) - model::kNumMarkers<M> + missed;
  return kPrice<S> * static_cast<S>(missed + (surplus > 0 ? surplus : 0));
}

/// Whether joints stand beyond their range by more than noise and a bent stop can make: 2 % of it.
template <class M, class S>
bool within_ranges(const Vec<S, model::kNumJoints<M>>& joints) noexcept {
  for (int j = 0; j < model::kNumJoints<M>; ++j) {
    const auto range = joint_range<M, S>(j);
    const S slack = S(0.02) * range.length();
    if (!(joints[j] >= range.low - slack && joints[j] <= range.high + slack)) return false;
  }
  return true;
}

/// Whether every joint that markers can tell of is told by a paired one.
template <class M, class S>
bool is_determined(const Hypothesis<M, S>& hypothesis) noexcept {
  JointSet told = 0, all = 0;
  for (std::size_t m = 0; m < hypothesis.sighting.size(); ++m) {
    if (M::kMarkers[m].kind == model::MarkerKind::point) continue;
    const JointSet joints = joints_between<M>(hypothesis.anchor, M::kMarkers[m].body);
    all |= joints;
    if (hypothesis.sighting[m] >= 0) told |= joints;
  }
  return (all & ~told) == 0;
}

/// Two hypotheses say different things if a marker that one of them has seen is elsewhere in the other, or another
/// mark.
template <class M, class S>
bool is_distinct(const Hypothesis<M, S>& x, const Hypothesis<M, S>& y) noexcept {
  const auto kin_x = model::forward_kinematics<M, S>(x.q.joints), kin_y = model::forward_kinematics<M, S>(y.q.joints);
  for (std::size_t m = 0; m < x.sighting.size(); ++m) {
    if (x.sighting[m] < 0 && y.sighting[m] < 0) continue;  // it may be anywhere
    if (x.sighting[m] >= 0 && y.sighting[m] >= 0 && x.sighting[m] != y.sighting[m]) return true;
    const Vec<S, 3> apart = x.q.T_cam_obj * kin_x.markers[m].centre - y.q.T_cam_obj * kin_y.markers[m].centre;
    const S radius_m = static_cast<S>(0.5 * M::kMarkers[m].outer_diameter_m);
    if (apart.squaredNorm() > radius_m * radius_m) return true;
  }
  return false;
}

/// Of several hypotheses the one whose markers are nearest to where q has them. There must be one.
template <class M, class S, std::size_t N>
const Hypothesis<M, S>& nearest(const FixedVector<Hypothesis<M, S>, N>& hypotheses,
                                const model::Configuration<M, S>& q) noexcept {
  const auto kin_q = model::forward_kinematics<M, S>(q.joints);
  std::size_t best = 0;
  S least = std::numeric_limits<S>::infinity();
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    const auto& [T_cam_obj, joints] = hypotheses[k].q;
    const auto kinematics = model::forward_kinematics<M, S>(joints);
    S sum{0};
    for (std::size_t m = 0; m < kinematics.markers.size(); ++m) {
      sum += (T_cam_obj * kinematics.markers[m].centre - q.T_cam_obj * kin_q.markers[m].centre).squaredNorm();
    }
    if (sum < least) best = k, least = sum;
  }
  return hypotheses[best];
}

}  // namespace articam::tracker
