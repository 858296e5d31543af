#pragma once
/// @file  Symmetric matrices of unknowns that form a tree, and their factorisation without fill-in.
///
/// Unknown i hangs below kParent[i] < i, the first below -1, and entry (k, i) can differ from 0 only where i is on
/// the way from k to the root. An object's normal equations are so: the joints of two branches share no marker. Worked
/// from the last unknown to the first, H = L^T D L has no entry where H has none.
///
/// Source  Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees",
///         IJRR 24(6), 2005 (his LTDL; an object's information is for us what inertia is there).

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/math/types.hpp"
#include "core/status.hpp"

namespace articam::math {

/// Unknowns that all depend on each other: their tree is one chain.
template <int N>
struct Chain {
  static constexpr auto kParent = [] {
    std::array<std::int16_t, static_cast<std::size_t>(N)> parent{};
    for (std::size_t k = 0; k < parent.size(); ++k) parent[k] = static_cast<std::int16_t>(static_cast<int>(k) - 1);
    return parent;
  }();
};

/// Where the entries of a tree's matrices are stored, and the operations that factorise one, all known at compile time.
template <class Tree>
struct TreePattern {
  static constexpr int kSize = static_cast<int>(Tree::kParent.size());
  using Index = std::int16_t;

  static constexpr int parent(int k) noexcept { return Tree::kParent[static_cast<std::size_t>(k)]; }
  /// Entries of a row.
  static constexpr int length(int row) noexcept {
    int n = 0;
    for (int i = row; i >= 0; i = parent(i)) ++n;
    return n;
  }
  static constexpr int kEntries = [] {
    int n = 0;
    for (int row = 0; row < kSize; ++row) n += length(row);
    return n;
  }();

  /// kEntry[k][i], i <= k: where that entry is stored, a row from the diagonal to the root; -1 where it is always 0.
  static constexpr auto kEntry = [] {
    std::array<std::array<Index, kSize>, kSize> entry{};
    int next = 0;
    for (std::size_t k = 0; k < kSize; ++k) {
      for (std::size_t i = 0; i < kSize; ++i) entry[k][i] = -1;
      for (int i = static_cast<int>(k); i >= 0; i = parent(i)) {
        entry[k][static_cast<std::size_t>(i)] = static_cast<Index>(next++);
      }
    }
    return entry;
  }();
  static constexpr Index entry(int k, int i) noexcept {
    return kEntry[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
  }

  /// target -= left right
  struct Update {
    Index target, left, right;
  };
  /// Calls visit(row, i, k) for each product (k, row) (k, i) that belongs to the entry (row, i), the last row first.
  template <class Visit>
  static constexpr void for_each_product(Visit&& visit) noexcept {
    for (int row = kSize - 1; row >= 0; --row) {
      for (int i = row; i >= 0; i = parent(i)) {
        for (int k = kSize - 1; k > row; --k) {
          if (entry(k, row) >= 0) visit(row, i, k);
        }
      }
    }
  }
  static constexpr std::size_t kNumUpdates = [] {
    std::size_t n = 0;
    for_each_product([&](int, int, int) { ++n; });
    return n;
  }();
  static constexpr auto kUpdates = [] {
    std::array<Update, kNumUpdates> updates{};
    std::size_t n = 0;
    for_each_product([&](int row, int i, int k) { updates[n++] = {entry(row, i), entry(k, row), entry(k, i)}; });
    return updates;
  }();
  /// kFirstUpdate[row]: the updates of a row's entries begin there and end where those of row - 1 begin.
  static constexpr auto kFirstUpdate = [] {
    std::array<std::size_t, kSize + 1> first{};
    for_each_product([&](int row, int, int) { ++first[static_cast<std::size_t>(row)]; });
    std::size_t sum = 0;
    for (std::size_t row = kSize; row-- > 0;) {
      const std::size_t count = first[row];
      first[row] = sum;
      sum += count;
    }
    return first;
  }();
  static constexpr std::size_t first_update(int row) noexcept {
    return row < 0 ? kNumUpdates : kFirstUpdate[static_cast<std::size_t>(row)];
  }

  static constexpr std::size_t num_updates(int row) noexcept { return first_update(row - 1) - first_update(row); }

  /// The entries off the diagonal, row by row.
  struct Link {
    Index entry, row, column;
  };
  static constexpr auto kLinks = [] {
    std::array<Link, static_cast<std::size_t>(kEntries - kSize)> links{};
    std::size_t n = 0;
    for (int row = 0; row < kSize; ++row) {
      for (int i = parent(row); i >= 0; i = parent(i)) {
        links[n++] = {entry(row, i), static_cast<Index>(row), static_cast<Index>(i)};
      }
    }
    return links;
  }();

  /// Straight code up to here, loops over the same lists beyond: 12 unknowns that all depend on each other.
  static constexpr bool kStraight = kNumUpdates <= 300;
};

/// A symmetric matrix of a tree's unknowns.
template <class Tree, class S>
struct TreeMatrix {
  using Pattern = TreePattern<Tree>;
  std::array<S, static_cast<std::size_t>(Pattern::kEntries)> entries;

  /// The entry of a row and a column on its way to the root; nothing else is stored.
  constexpr S& at(int row, int column) noexcept {
    return entries[static_cast<std::size_t>(Pattern::entry(row, column))];
  }
  /// Any entry.
  constexpr S operator()(int i, int j) const noexcept {
    const auto entry = i < j ? Pattern::entry(j, i) : Pattern::entry(i, j);
    return entry < 0 ? S(0) : entries[static_cast<std::size_t>(entry)];
  }
};

/// H = L^T D L of a positive definite matrix.
template <class Tree, class S>
class TreeFactor {
 public:
  using Pattern = TreePattern<Tree>;
  static constexpr int kSize = Pattern::kSize;

  /// Factorises H with its diagonal raised by the share `damping`.
  /// Errors  ill_conditioned when a pivot is not positive, or not a number.
  Status factorise(const TreeMatrix<Tree, S>& H, S damping = S(0)) noexcept {
    Entries U;  // H, to become D L
    if constexpr (Pattern::kStraight) {
      load(H.entries, U, std::make_index_sequence<std::tuple_size_v<Entries>>{});
    } else {
      U = H.entries;
    }
    for (int row = 0; row < kSize; ++row) U[at(Pattern::entry(row, row))] *= S(1) + damping;
    Pivots pivots{std::numeric_limits<S>::max(), S(0)};
    if constexpr (Pattern::kStraight) {
      eliminate_straight(U, pivots, std::make_integer_sequence<int, kSize>{});
    } else {
      for (int row = kSize - 1; row >= 0; --row) {
        for (std::size_t n = Pattern::first_update(row); n < Pattern::first_update(row - 1); ++n) update(U, n);
        invert_pivot(U, row, pivots);
        const auto first = at(Pattern::entry(row, row)), end = first + static_cast<std::size_t>(Pattern::length(row));
        for (std::size_t n = first + 1; n < end; ++n) scale(U, row, n);
      }
    }
    // A pivot that is not a number makes a sum that is none.
    return pivots.least > std::numeric_limits<S>::min() && is_finite(pivots.sum) ? Status::ok : Status::ill_conditioned;
  }

  /// x of H x = b, in the place of b, kSize numbers; only after factorise() returned ok.
  void solve(S* x) const noexcept {
    if constexpr (Pattern::kStraight) {
      solve_straight(x, std::make_index_sequence<kLinks>{}, std::make_index_sequence<kSize>{});
    } else {
      for (std::size_t n = kLinks; n-- > 0;) pass_up(x, n);
      for (std::size_t i = 0; i < inverse_D_.size(); ++i) x[i] *= inverse_D_[i];
      for (std::size_t n = 0; n < kLinks; ++n) pass_down(x, n);
    }
  }

 private:
  using Entries = std::array<S, static_cast<std::size_t>(Pattern::kEntries)>;
  static constexpr std::size_t kLinks = Pattern::kLinks.size();

  static constexpr std::size_t at(typename Pattern::Index i) noexcept { return static_cast<std::size_t>(i); }

  struct Pivots {
    S least, sum;
  };

  // What follows is forced into its caller. Where row and n are constants there, nothing is left of the tables.
  [[gnu::always_inline]] void update(Entries& U, std::size_t n) const noexcept {
    const auto& [target, left, right] = Pattern::kUpdates[n];
    U[at(target)] -= L_[at(left)] * U[at(right)];
  }
  [[gnu::always_inline]] void invert_pivot(const Entries& U, int row, Pivots& pivots) noexcept {
    const S d = U[at(Pattern::entry(row, row))];
    pivots.least = d < pivots.least ? d : pivots.least;
    pivots.sum += d;
    inverse_D_[static_cast<std::size_t>(row)] = S(1) / d;
  }
  [[gnu::always_inline]] void scale(const Entries& U, int row, std::size_t n) noexcept {
    L_[n] = U[n] * inverse_D_[static_cast<std::size_t>(row)];
  }
  [[gnu::always_inline]] void pass_up(S* x, std::size_t n) const noexcept {
    const auto& [entry, row, column] = Pattern::kLinks[n];
    x[at(column)] -= L_[at(entry)] * x[at(row)];
  }
  [[gnu::always_inline]] void pass_down(S* x, std::size_t n) const noexcept {
    const auto& [entry, row, column] = Pattern::kLinks[n];
    x[at(row)] -= L_[at(entry)] * x[at(column)];
  }

  template <std::size_t... n>
  [[gnu::always_inline]] static void load(const Entries& from, Entries& to, std::index_sequence<n...>) noexcept {
    ((to[n] = from[n]), ...);  // one by one, so that they can stay in registers
  }
  template <int... k>
  [[gnu::always_inline]] void eliminate_straight(Entries& U, Pivots& pivots,
                                                 std::integer_sequence<int, k...>) noexcept {
    constexpr int kLast = kSize - 1;
    (eliminate_row<kLast - k>(U, pivots, std::make_index_sequence<Pattern::num_updates(kLast - k)>{},
                              std::make_index_sequence<Pattern::length(kLast - k) - 1>{}),
     ...);
  }
  template <int kRow, std::size_t... n, std::size_t... i>
  [[gnu::always_inline]] void eliminate_row(Entries& U, Pivots& pivots, std::index_sequence<n...>,
                                            std::index_sequence<i...>) noexcept {
    (update(U, Pattern::first_update(kRow) + n), ...);
    invert_pivot(U, kRow, pivots);
    (scale(U, kRow, at(Pattern::entry(kRow, kRow)) + 1 + i), ...);
  }
  template <std::size_t... n, std::size_t... i>
  [[gnu::always_inline]] void solve_straight(S* x, std::index_sequence<n...>,
                                             std::index_sequence<i...>) const noexcept {
    (pass_up(x, kLinks - 1 - n), ...);
    ((x[i] *= inverse_D_[i]), ...);
    (pass_down(x, n), ...);
  }

  Entries L_;
  std::array<S, static_cast<std::size_t>(kSize)> inverse_D_;
};

/// H^-1, symmetric to the bit. Errors  ill_conditioned; `inverse` is then unchanged.
template <class Tree, class S>
Status invert(const TreeMatrix<Tree, S>& H,
              Mat<S, TreePattern<Tree>::kSize, TreePattern<Tree>::kSize>& inverse) noexcept {
  constexpr int kSize = TreePattern<Tree>::kSize;
  TreeFactor<Tree, S> factor;
  if (const Status status = factor.factorise(H); status != Status::ok) return status;
  for (int j = 0; j < kSize; ++j) {
    std::array<S, static_cast<std::size_t>(kSize)> x{};
    x[static_cast<std::size_t>(j)] = S(1);
    factor.solve(x.data());
    for (int i = j; i < kSize; ++i) inverse(i, j) = inverse(j, i) = x[static_cast<std::size_t>(i)];
  }
  return Status::ok;
}

/// The same of a symmetric matrix, whose lower triangle is read.
template <class S, int N>
Status invert(const Mat<S, N, N>& H, Mat<S, N, N>& inverse) noexcept {
  TreeMatrix<Chain<N>, S> packed;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j <= i; ++j) packed.at(i, j) = H(i, j);
  }
  return invert(packed, inverse);
}

}  // namespace articam::math
