#pragma once
/// @file  The mirror image of what is tracked, kept until the frames have decided between the two.
///
/// A flat object seen nearly from the front, or small, looks the same when its tilt is reversed. A tracker that has
/// once gone into the wrong one of the two stays there, and one that takes the better one in each frame jumps to and
/// fro. Here both are followed, and the difference of their costs is summed over the frames: the sum of the logarithms
/// of likelihoods. The output changes sides when the sum says so at odds of 1 to e^12, and not before.

#include <algorithm>
#include <utility>

#include "core/tracker/consensus.hpp"
#include "core/tracker/mirror_image.hpp"

namespace articam::tracker {

template <class M, class S>
class Rival {
 public:
  using Configuration = model::Configuration<M, S>;

  /// Follows the mirror image of `found` in this frame. True: it has taken the place of `found`, and that is not where
  /// the frames before have led. Where nothing is decided, the covariance of `found` holds both, and what they differ
  /// in is disputed. `expected`: from the frames before; a frame whose own optimum lies on the other side is no
  /// evidence yet.
  bool challenge(const Matches<M, S>& matches, const Configuration& expected, Consensus<M, S>& found) noexcept {
    const bool leapt = turn2(expected, found.solution.q) > kLeap2;
    const bool appears = (leapt || (!alive_ && ++frames_ % kPause == 0)) && appear(matches, found.solution);
    if (!alive_ && !appears) return false;
    Solution<M, S> solution = solve(matches, open_prior<M, S>(q_), q_, appears ? kFirstIterations : kIterations);
    alive_ = solution.status == Status::ok && solution.converged && is_distinct(solution, found.solution);
    if (!alive_) return false;
    if (leapt && turn2(expected, solution.q) < turn2(expected, found.solution.q)) std::swap(found.solution, solution);
    q_ = solution.q;
    lead_ += misfit(matches, found.solution) - misfit(matches, solution);
    if (lead_ < -kDecided) return alive_ = false;
    if (lead_ > kDecided) {
      q_ = found.solution.q, lead_ = S(0);
      found.solution = solution;
      return true;
    }
    if (stands()) found.widen(q_);
    return false;
  }

  /// It cannot be told from what is given out.
  bool stands() const noexcept { return alive_ && lead_ > -kStillPossible<S>; }

 private:
  static constexpr S kDecided{24};
  static constexpr int kFirstIterations = 20, kIterations = 8;
  static constexpr int kPause = 8;      ///< frames between two looks for it
  static constexpr S kLeap2 = S(7e-4);  ///< (1.5 deg)^2 beyond what was expected are looked into at once

  static S turn2(const Configuration& a, const Configuration& b) noexcept {
    return math::log_so3<S>(b.T_cam_obj.R * a.T_cam_obj.R.conjugate()).squaredNorm();
  }
  static S misfit(const Matches<M, S>& matches, const Solution<M, S>& solution) noexcept {
    return S(2) * linearise(matches, solution.q, FeatureKind::imaged_circle, solution.scale).cost;
  }
  /// Turned by more than a degree and by more than a deviation.
  static bool is_distinct(const Solution<M, S>& a, const Solution<M, S>& b) noexcept {
    const S variance = a.covariance(3, 3) + a.covariance(4, 4) + a.covariance(5, 5);
    return turn2(a.q, b.q) > S(3e-4) && turn2(a.q, b.q) > variance;
  }

  /// The body with most marks is mirrored.
  bool appear(const Matches<M, S>& matches, const Solution<M, S>& solution) noexcept {
    std::array<int, M::kJoints.size() + 1> marks{};
    Hypothesis<M, S> seen{.q = solution.q};
    for (std::size_t m = 0; m < matches.size(); ++m) {
      seen.sighting[m] = matches[m].matched ? std::int8_t{0} : std::int8_t{-1};
      if (matches[m].matched) ++marks[static_cast<std::size_t>(M::kMarkers[m].body + 1)];
    }
    seen.anchor = static_cast<int>(std::max_element(marks.begin(), marks.end()) - marks.begin()) - 1;
    const auto mirrored = mirror_image(seen);
    if (!mirrored.ok()) return false;
    q_ = mirrored.value(), lead_ = S(0);
    return true;
  }

  Configuration q_{};
  S lead_{};  ///< how much better it explains the frames, in units of 2 ln of the odds
  int frames_{};
  bool alive_{};
};

}  // namespace articam::tracker
