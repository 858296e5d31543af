#pragma once
/// @file  The value of a joint, the base being known: where on its travel does a marker meet a mark?

#include "core/tracker/hypothesis.hpp"

namespace articam::tracker {

/// The travel of a joint is cut into this many pieces, on each of which a marker's image moves straight: over a whole
/// turn of radius R the path is off by R / 80 at most.
inline constexpr int kTravelPieces = 20;

/// Moves joint j to `value`; the anchor body stays where it is in {cam}.
template <class M, class S>
model::Configuration<M, S> with_joint(model::Configuration<M, S> q, int anchor, int j, S value) noexcept {
  if (anchor < 0) {
    q.joints[j] = value;
    return q;
  }
  const auto body = static_cast<std::size_t>(anchor);
  const Pose<S> T_cam_anchor = q.T_cam_obj * model::forward_kinematics<M, S>(q.joints).T_obj_body[body];
  q.joints[j] = value;
  q.T_cam_obj = T_cam_anchor * model::forward_kinematics<M, S>(q.joints).T_obj_body[body].inverse();
  return q;
}

/// Whether a joint moves markers straight on: its rows all slide.
template <class M>
constexpr bool is_slide(int j) noexcept {
  for (int row = 0; row < model::kNumBodies<M>; ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (model::kValueOfRow<M>[i] == j && M::kJoints[i].kind != model::JointKind::prismatic) return false;
  }
  return true;
}

/// Pieces into which the search cuts a joint's travel; of a slide none.
template <class M>
constexpr int travel_pieces(int j) noexcept {
  return is_slide<M>(j) ? 1 : kTravelPieces;
}

/// A value of a joint that puts a marker near a mark.
template <class S>
struct JointGuess {
  S value{};
  S score{};  ///< markers explained, each by 1 less its squared distance in reaches
};

/// The search along one joint, for a configuration whose other joints in `known` stand where they are.
template <class M, class S>
class JointSearch {
 public:
  using Configuration = model::Configuration<M, S>;
  static constexpr std::size_t kMaxGuesses = 4;

  JointSearch(const Sightings<M, S>& sightings, const vision::CameraModel<S>& camera, S reach) noexcept
      : sightings_{sightings}, camera_{camera}, reach_{reach} {}

  /// Values at which a marker that `j` places lies on a mark that `taken` leaves free, the best first.
  FixedVector<JointGuess<S>, kMaxGuesses> search(const Configuration& q, int anchor, JointSet known, int j,
                                                 const Pairing<M>& taken) const noexcept {
    const auto range = joint_range<M, S>(j);
    const S length = range.length() / static_cast<S>(travel_pieces<M>(j));
    FixedVector<JointGuess<S>, kMaxGuesses> guesses;
    Centres from = centres(with_joint<M, S>(q, anchor, j, range.low));
    for (int piece = 0; piece < travel_pieces<M>(j); ++piece) {
      const S begin = range.low + length * static_cast<S>(piece);
      const Centres to = centres(with_joint<M, S>(q, anchor, j, begin + length));
      for (std::size_t m = 0; m < from.size(); ++m) {
        if (!is_moved(m, anchor, known, j)) continue;
        for (std::size_t i = 0; i < sightings_.size(); ++i) {
          if (sightings_[i].kind != mark_kind(M::kMarkers[m].kind) || is_taken(taken, i)) continue;
          const S radius_m = static_cast<S>(0.5 * M::kMarkers[m].outer_diameter_m);
          const S share = nearest(from[m], to[m], radius_m, sightings_[i]);
          if (share >= S(0)) keep({begin + share * length, S(0)}, q, anchor, known, j, taken, guesses);
        }
      }
      from = to;
    }
    return guesses;
  }

 private:
  static bool is_moved(std::size_t m, int anchor, JointSet known, int j) noexcept {
    return is_placed<M>(m, anchor, known | JointSet{1} << j) && !is_placed<M>(m, anchor, known);
  }
  static bool is_taken(const Pairing<M>& taken, std::size_t i) noexcept {
    for (const std::int8_t sighting : taken) {
      if (sighting == static_cast<std::int8_t>(i)) return true;
    }
    return false;
  }

  using Centres = std::array<Vec<S, 3>, static_cast<std::size_t>(model::kNumMarkers<M>)>;
  static Centres centres(const Configuration& q) noexcept {
    Centres centres;
    const auto kinematics = model::forward_kinematics<M, S>(q.joints);
    for (std::size_t m = 0; m < centres.size(); ++m) centres[m] = q.T_cam_obj * kinematics.markers[m].centre;
    return centres;
  }

  /// Where on a straight path a marker is nearest to the ray of a mark, 0 to 1; -1 where that is out of reach.
  S nearest(const Vec<S, 3>& from, const Vec<S, 3>& to, S radius_m, const Sighting<S>& seen) const noexcept {
    const Vec<S, 3> ray = seen.s_star.homogeneous().normalized();
    const Vec<S, 3> start = from - ray * ray.dot(from), path = (to - from) - ray * ray.dot(to - from);  // across it
    const S length2 = path.squaredNorm();
    S share = length2 > S(1e-12) ? -start.dot(path) / length2 : S(0.5);
    share = share < S(0) ? S(0) : (share > S(1) ? S(1) : share);
    const S most = reach_ * radius_m;
    return (start + share * path).squaredNorm() < most * most ? share : S(-1);
  }

  S score(const Configuration& q, int anchor, JointSet known, int j, const Pairing<M>& taken) const noexcept {
    const auto markers = appear<M, S>(q, camera_);
    S sum{0};
    for (std::size_t m = 0; m < markers.size(); ++m) {
      if (!is_moved(m, anchor, known, j) || !markers[m].visible) continue;
      S least{1};
      for (std::size_t i = 0; i < sightings_.size(); ++i) {
        if (sightings_[i].kind != mark_kind(M::kMarkers[m].kind) || is_taken(taken, i)) continue;
        const S most = reach_ * markers[m].radius;
        const S d2 = (sightings_[i].s_star - markers[m].s).squaredNorm() / (most * most);
        if (d2 < least && shape_distance2(markers[m].shape, sightings_[i].shape) < S(1)) least = d2;
      }
      sum += S(1) - least;
    }
    return sum;
  }

  /// Puts a guess into its place; of two within half a piece the better one stays.
  void keep(JointGuess<S> guess, const Configuration& q, int anchor, JointSet known, int j, const Pairing<M>& taken,
            FixedVector<JointGuess<S>, kMaxGuesses>& guesses) const noexcept {
    guess.score = score(with_joint<M, S>(q, anchor, j, guess.value), anchor, known, j, taken);
    if (!(guess.score > S(0))) return;
    const S near = S(0.5) * joint_range<M, S>(j).length() / S(kTravelPieces);
    for (std::size_t k = 0; k < guesses.size(); ++k) {
      if (std::abs(guesses[k].value - guess.value) > near) continue;
      if (guess.score > guesses[k].score) guesses[k] = guess;
      return sort(guesses);
    }
    if (!guesses.push_back(guess) && guesses[kMaxGuesses - 1].score < guess.score) guesses[kMaxGuesses - 1] = guess;
    sort(guesses);
  }
  static void sort(FixedVector<JointGuess<S>, kMaxGuesses>& guesses) noexcept {
    for (std::size_t k = 1; k < guesses.size(); ++k) {
      for (std::size_t i = k; i > 0 && guesses[i - 1].score < guesses[i].score; --i) {
        const auto better = guesses[i];
        guesses[i] = guesses[i - 1], guesses[i - 1] = better;
      }
    }
  }

  const Sightings<M, S>& sightings_;
  const vision::CameraModel<S>& camera_;
  S reach_;
};

}  // namespace articam::tracker
