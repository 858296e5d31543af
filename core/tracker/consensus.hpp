#pragma once
/// @file  Which marks lie: explanations that leave some out, weighed against each other.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/fixed_vector.hpp"
#include "core/tracker/vvs.hpp"

namespace articam::tracker {

/// What it costs to leave a mark out, in units of -2 ln of a likelihood: odds of a few hundred against its lying, and
/// then it may be anywhere in a neighbourhood of hundreds of deviations. One that is off by 5 deviations is kept.
template <class S>
inline constexpr S kLeaveOut{25};

/// An explanation that costs no more than this above the cheapest stands beside it: odds of 1 to 150.
template <class S>
inline constexpr S kStillPossible{10};

/// What an explanation leaves out: marks, what all shapes say (blur, glare or a print of another size spoil all), or
/// the joints' limits (the object has another range than the model).
struct LeftOut {
  static constexpr int kNobody = -1;
  std::array<int, 2> marks{kNobody, kNobody};
  bool shapes{}, limits{};

  constexpr int num_marks() const noexcept { return (marks[0] >= 0 ? 1 : 0) + (marks[1] >= 0 ? 1 : 0); }
  constexpr int count() const noexcept { return num_marks() + (shapes ? 1 : 0) + (limits ? 1 : 0); }
  template <class M, class S>
  constexpr void remove_from(Matches<M, S>& matches) const noexcept {
    for (const int mark : marks) {
      if (mark >= 0) matches[static_cast<std::size_t>(mark)].matched = false;
    }
    if (!shapes) return;
    for (auto& match : matches) match.shape_variance = S(0);
  }
};

/// A solution, and what was left out of it.
template <class M, class S>
struct Consensus {
  Solution<M, S> solution{};  ///< its covariance holds every explanation that is still possible; where limits were left
                              ///< out, its q is beyond one
  std::array<bool, static_cast<std::size_t>(model::kDof<M>)> disputed{};  ///< where those differ by 3 deviations
  LeftOut left_out{};
  bool contradictory{};  ///< the marks disagree, and leaving out two of them does not mend it

  /// Makes the covariance hold another explanation, two deviations away.
  void widen(const model::Configuration<M, S>& other) noexcept {
    constexpr S kShare{0.25};
    auto& P = solution.covariance;
    const auto d = model::difference<M, S>(solution.q, other);
    for (int i = 0; i < model::kDof<M>; ++i) {
      disputed[static_cast<std::size_t>(i)] |= d[i] * d[i] > S(9) * P(i, i);
      for (int j = 0; j < model::kDof<M>; ++j) P(i, j) += kShare * d[i] * d[j];
    }
  }
};

/// Moves the last item before all that it precedes, back to `first`: the others are in order.
template <class Items, class Less>
void sort_in_last(Items& items, std::size_t first, Less&& less) noexcept {
  for (std::size_t i = items.size(); i-- > first + 1 && less(items[i], items[i - 1]);)
    std::swap(items[i], items[i - 1]);
}

/// Tries explanations one by one and keeps what they say.
template <class M, class S>
class Explanations {
 public:
  static constexpr std::size_t kSuspects = 6;  ///< marks that are left out singly
  static constexpr std::size_t kPaired = 3;    ///< of them, those with which a second one is
  static constexpr std::size_t kMost = 3 + kSuspects + kPaired * (kSuspects - 1);  ///< solutions of a frame
  using Configuration = model::Configuration<M, S>;

  Explanations(const Matches<M, S>& matches, const Prior<M, S>& prior, const Configuration& start,
               int max_iterations) noexcept
      : matches_{matches}, prior_{prior}, start_{start}, max_iterations_{max_iterations} {
    consider({});
  }

  bool all_agree() const noexcept { return all_.empty() || all_[0].excess <= kLeaveOut<S>; }

  /// Without limits that press, without the shapes, without each of the marks that fit worst, then without two.
  void leave_out() noexcept {
    if (best_.beyond_limit) consider({.limits = true});
    consider({.shapes = true});
    const auto suspects = find_suspects();
    const std::size_t singles = all_.size();
    for (const int mark : suspects) {
      consider({.marks = {mark, LeftOut::kNobody}});
      sort_in_last(all_, singles, cheaper);
    }
    const std::size_t end = all_.size();
    for (std::size_t first = singles; first < end && first < singles + kPaired; ++first) {
      for (std::size_t second = first + 1; second < end; ++second) {
        consider({.marks = {all_[first].left_out.marks[0], all_[second].left_out.marks[0]}});
      }
    }
  }

  /// The cheapest, widened by those that are nearly as cheap.
  Consensus<M, S> conclude() const noexcept {
    Consensus<M, S> result{best_};
    if (best_.status != Status::ok) return result;
    const Explanation& best = *std::min_element(all_.begin(), all_.end(), cheaper);
    result.left_out = best.left_out;
    result.solution.beyond_limit |= best.left_out.limits;
    result.contradictory = best.excess > kLeaveOut<S>;
    for (const Explanation& other : all_) {
      if (&other != &best && other.cost <= best.cost + kStillPossible<S>) result.widen(other.q);
    }
    return result;
  }

 private:
  struct Explanation {
    LeftOut left_out{};
    Configuration q{};
    S excess{};  ///< over what a true one has
    S cost{};    ///< with the price of what is left out
  };
  static bool cheaper(const Explanation& a, const Explanation& b) noexcept { return a.cost < b.cost; }

  Matches<M, S> without(const LeftOut& left_out) const noexcept {
    Matches<M, S> rest = matches_;
    left_out.template remove_from<M, S>(rest);
    return rest;
  }

  void consider(const LeftOut& left_out) noexcept {
    const Matches<M, S> rest = without(left_out);
    const Solution<M, S> solution = solve(rest, prior_, start_, max_iterations_, !left_out.limits);
    if (solution.status != Status::ok) {
      if (all_.empty()) best_ = solution;
      return;
    }
    const S excess = S(2) * solution.cost - static_cast<S>(num_equations<M, S>(rest));
    const S price = kLeaveOut<S> * static_cast<S>(left_out.count());
    const Explanation found{left_out, solution.q, excess, excess + price};
    if (all_.empty() || found.cost < std::min_element(all_.begin(), all_.end(), cheaper)->cost) best_ = solution;
    (void)all_.push_back(found);
  }

  /// The marks that cost most where all are kept.
  FixedVector<int, kSuspects> find_suspects() const noexcept {
    std::array<S, static_cast<std::size_t>(model::kNumMarkers<M>)> cost_without;
    const auto dearer = [&](int a, int b) {
      return cost_without[static_cast<std::size_t>(a)] < cost_without[static_cast<std::size_t>(b)];
    };
    FixedVector<int, kSuspects> worst;
    for (int mark = 0; mark < model::kNumMarkers<M>; ++mark) {
      if (!matches_[static_cast<std::size_t>(mark)].matched) continue;
      const auto rest = linearise(without({.marks = {mark, LeftOut::kNobody}}), prior_, all_[0].q);
      if (rest.status != Status::ok) continue;
      cost_without[static_cast<std::size_t>(mark)] = rest.cost;
      if (!worst.push_back(mark) && dearer(mark, worst[kSuspects - 1])) worst[kSuspects - 1] = mark;
      sort_in_last(worst, 0, dearer);
    }
    return worst;
  }

  const Matches<M, S>& matches_;
  const Prior<M, S>& prior_;
  const Configuration& start_;
  int max_iterations_;
  FixedVector<Explanation, kMost> all_{};
  Solution<M, S> best_{};
};

/// Solves with all matches, and where they disagree among themselves or with the prior by more than it costs to leave
/// something out, tries that, too. An explanation costs
///
///     2 (measurements + prior) - equations + kLeaveOut for each mark, for the shapes, for the limits that it leaves
///     out
///
/// of which the first two cancel in the mean where it is true; the cheapest is taken, and `matches` loses what it
/// leaves out. The prior and the shapes bear witness: a mark can be found to lie where the centres are not redundant.
/// Where another explanation is nearly as cheap, nobody knows which mark lies, and the covariance holds both.
///
/// Work  at most Explanations::kMost solutions.
template <class M, class S>
Consensus<M, S> solve_with_consensus(Matches<M, S>& matches, const Prior<M, S>& prior,
                                     const model::Configuration<M, S>& start, int max_iterations) noexcept {
  Explanations<M, S> explanations{matches, prior, start, max_iterations};
  if (!explanations.all_agree()) explanations.leave_out();
  const Consensus<M, S> result = explanations.conclude();
  result.left_out.template remove_from<M, S>(matches);
  return result;
}

}  // namespace articam::tracker
