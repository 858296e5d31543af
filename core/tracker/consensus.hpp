#pragma once
/// @file  One wild match among the good ones: find it by leaving each out in turn.

#include "core/tracker/vvs.hpp"

namespace articam::tracker {

/// A solution, and the marker that was left out of it (-1: none).
template <class M, class S>
struct Consensus {
  Solution<M, S> solution{};
  int outlier{-1};
  bool contradictory{};  ///< the matches disagree, and leaving out any one of them does not mend it
};

/// Mean squared normalised distance; 1 is what the detector's variances promise.
template <class S>
S per_equation(S chi2, int matched) noexcept {
  return matched > 0 ? chi2 / static_cast<S>(2 * matched) : S(0);
}

/// Solves with all matches; if they contradict each other, solves again without each of them in turn and takes the
/// cheapest solution that agrees within itself. A match is only blamed while the others together still have more
/// equations than unknowns: without redundancy nothing could tell which one lies, and all are kept.
///
/// `consistent` is the largest mean squared normalised distance of good matches. `matches` loses the outlier.
/// Work  at most 1 + p solutions.
template <class M, class S>
Consensus<M, S> solve_with_consensus(Matches<M, S>& matches, const Prior<M, S>& prior,
                                     const model::Configuration<M, S>& start, S consistent,
                                     int max_iterations) noexcept {
  Consensus<M, S> best{solve(matches, prior, start, max_iterations), -1};
  const int matched = count<M, S>(matches);
  if (best.solution.status != Status::ok || per_equation(best.solution.chi2, matched) <= consistent) return best;
  if (2 * (matched - 1) <= model::kDof<M>) return best;

  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].matched) continue;
    auto others = matches;
    others[i].matched = false;
    const auto solution = solve(others, prior, start, max_iterations);
    if (solution.status != Status::ok || per_equation(solution.chi2, matched - 1) > consistent) continue;
    if (best.outlier < 0 || solution.cost < best.solution.cost) best = {solution, static_cast<int>(i)};
  }
  best.contradictory = best.outlier < 0;
  if (best.outlier >= 0) matches[static_cast<std::size_t>(best.outlier)].matched = false;
  return best;
}

}  // namespace articam::tracker
