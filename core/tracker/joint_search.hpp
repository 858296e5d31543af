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

/// Whether joint j moves the centre of a marker that it alone keeps from being placed. A marker on the joint's own axis
/// turns where it is: its joint has to be found together with the next.
template <class M>
constexpr bool moves_a_centre(int anchor, JointSet known, int j) noexcept {
  constexpr double kOnAxis2_m2 = 1e-6;
  for (const model::MarkerRow& marker : M::kMarkers) {
    const JointSet between = joints_between<M>(anchor, marker.body) & ~known;
    if (marker.kind == model::MarkerKind::point || between != JointSet{1} << j) continue;
    if (marker.body < 0 || model::kValueOfRow<M>[static_cast<std::size_t>(marker.body)] != j || is_slide<M>(j))
      return true;
    const auto& axis = M::kJoints[static_cast<std::size_t>(marker.body)].axis;
    double along = 0, distance2 = 0;
    for (std::size_t i = 0; i < 3; ++i) along += axis[i] * marker.t_body_m[i];
    for (std::size_t i = 0; i < 3; ++i) {
      const double across = marker.t_body_m[i] - along * axis[i];
      distance2 += across * across;
    }
    if (distance2 > kOnAxis2_m2) return true;
  }
  return false;
}

/// A value of a joint that puts a marker near a mark.
template <class S>
struct JointGuess {
  S value{};
  S blind_value{};  ///< of the joint that is searched with it, see moves_a_centre()
  S score{};        ///< markers explained, each by 1 less its squared distance in reaches, and its shape's
};

/// What is sought: the value of `joint`, those of the joints in `known` being found, seen from the anchor body.
template <class M>
struct Sought {
  int anchor{};
  JointSet known{};
  int joint{};
  int blind{-1};  ///< a joint in `known` that stands anywhere: its value is sought as well
  Pairing<M> taken{};

  /// The markers that it is told by.
  bool moves(std::size_t m) const noexcept {
    return is_placed<M>(m, anchor, known | JointSet{1} << joint) && !is_placed<M>(m, anchor, known);
  }
  bool has_taken(std::size_t sighting) const noexcept {
    for (const std::int8_t i : taken) {
      if (i == static_cast<std::int8_t>(sighting)) return true;
    }
    return false;
  }
};

/// The search along one joint, or over two.
template <class M, class S>
class JointSearch {
 public:
  using Configuration = model::Configuration<M, S>;
  static constexpr std::size_t kMaxGuesses = 4;
  using Guesses = FixedVector<JointGuess<S>, kMaxGuesses>;

  JointSearch(const Sightings<M, S>& sightings, const vision::CameraModel<S>& camera, S reach) noexcept
      : sightings_{sightings}, camera_{camera}, reach_{reach} {}

  /// Values at which a marker lies on a mark that is not taken, the best first.
  Guesses search(const Configuration& q, const Sought<M>& sought) const noexcept {
    Guesses guesses;
    if (sought.blind < 0) {
      search_along(q, sought, S(0), guesses);
      return guesses;
    }
    const auto range = joint_range<M, S>(sought.blind);
    for (int piece = 0; piece < kTravelPieces; ++piece) {
      const S value = range.low + (static_cast<S>(piece) + S(0.5)) * range.length() / S(kTravelPieces);
      search_along(with_joint<M, S>(q, sought.anchor, sought.blind, value), sought, value, guesses);
    }
    return guesses;
  }

 private:
  void search_along(const Configuration& q, const Sought<M>& sought, S blind_value, Guesses& guesses) const noexcept {
    const int pieces = travel_pieces<M>(sought.joint);
    const auto range = joint_range<M, S>(sought.joint);
    const S length = range.length() / static_cast<S>(pieces);
    Centres from = centres(with_joint<M, S>(q, sought.anchor, sought.joint, range.low));
    for (int piece = 0; piece < pieces; ++piece) {
      const S begin = range.low + length * static_cast<S>(piece);
      const Centres to = centres(with_joint<M, S>(q, sought.anchor, sought.joint, begin + length));
      for (std::size_t m = 0; m < from.size(); ++m) {
        if (!sought.moves(m)) continue;
        for (std::size_t i = 0; i < sightings_.size(); ++i) {
          if (sightings_[i].kind != mark_kind(M::kMarkers[m].kind) || sought.has_taken(i)) continue;
          const S radius_m = static_cast<S>(0.5 * M::kMarkers[m].outer_diameter_m);
          const S share = nearest(from[m], to[m], radius_m, sightings_[i]);
          if (share >= S(0)) keep({begin + share * length, blind_value, S(0)}, q, sought, guesses);
        }
      }
      from = to;
    }
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

  S score(const Configuration& q, const Sought<M>& sought) const noexcept {
    const auto markers = appear<M, S>(q, camera_);
    S sum{0};
    for (std::size_t m = 0; m < markers.size(); ++m) {
      if (!sought.moves(m) || !markers[m].visible) continue;
      S least{1};
      for (std::size_t i = 0; i < sightings_.size(); ++i) {
        if (sightings_[i].kind != mark_kind(M::kMarkers[m].kind) || sought.has_taken(i)) continue;
        const S most = reach_ * markers[m].radius;
        const S d2 = (sightings_[i].s_star - markers[m].s).squaredNorm() / (most * most);
        const S misfit = d2 + shape_distance2(markers[m].shape, sightings_[i].shape);
        if (misfit < least) least = misfit;
      }
      sum += S(1) - least;
    }
    return sum;
  }

  /// Puts a guess into its place; of two within half a piece, of two joints within one, the better one stays.
  void keep(JointGuess<S> guess, const Configuration& q, const Sought<M>& sought, Guesses& guesses) const noexcept {
    guess.score = score(with_joint<M, S>(q, sought.anchor, sought.joint, guess.value), sought);
    if (!(guess.score > S(0))) return;
    const auto piece = [](int j) { return joint_range<M, S>(j).length() / S(kTravelPieces); };
    const bool two = sought.blind >= 0;
    const S near = (two ? S(1.01) : S(0.5)) * piece(sought.joint),
            near_blind = two ? S(1.01) * piece(sought.blind) : S(0);
    for (std::size_t k = 0; k < guesses.size(); ++k) {
      if (std::abs(guesses[k].value - guess.value) > near) continue;
      if (std::abs(guesses[k].blind_value - guess.blind_value) > near_blind) continue;
      if (guess.score > guesses[k].score) guesses[k] = guess;
      return sort(guesses);
    }
    if (!guesses.push_back(guess) && guesses[kMaxGuesses - 1].score < guess.score) guesses[kMaxGuesses - 1] = guess;
    sort(guesses);
  }
  static void sort(Guesses& guesses) noexcept {
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
