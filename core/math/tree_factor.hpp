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

  /// Products of the factorisation: for each k behind a row, one an entry of the row.
  static constexpr int kNumUpdates = [] {
    int n = 0;
    for (int k = 0; k < kSize; ++k) {
      for (int row = parent(k); row >= 0; row = parent(row)) n += length(row);
    }
    return n;
  }();

  /// Straight code up to here, loops beyond: 12 unknowns that all depend on each other.
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

/// H = L^T D L of a positive definite matrix. Kept is D L, and on its diagonal, where L has ones, D^-1.
template <class Tree, class S>
class TreeFactor {
 public:
  using Pattern = TreePattern<Tree>;
  static constexpr int kSize = Pattern::kSize;

  /// Factorises H with its diagonal raised by the share `damping`.
  /// Errors  ill_conditioned when a pivot is not positive, or not a number.
  [[gnu::always_inline]] Status factorise(const TreeMatrix<Tree, S>& H, S damping = S(0)) noexcept {
    Pivots pivots{std::numeric_limits<S>::max(), S(0)};
    if constexpr (Pattern::kStraight) {
      eliminate_straight(H, S(1) + damping, pivots, std::make_integer_sequence<int, kSize>{});
    } else {
      for (int row = kSize - 1; row >= 0; --row) eliminate(H, S(1) + damping, pivots, row);
    }
    // A pivot that is not a number makes a sum that is none.
    return pivots.least > std::numeric_limits<S>::min() && is_finite(pivots.sum) ? Status::ok : Status::ill_conditioned;
  }

  /// x of H x = b, kSize numbers each, x and b perhaps the same; only after factorise() returned ok.
  [[gnu::always_inline]] void solve(const S* b, S* x) const noexcept {
    if constexpr (Pattern::kStraight) {
      solve_straight(b, x, std::make_integer_sequence<int, kSize>{});
    } else {
      for (int row = 0; row < kSize; ++row) x[row] = b[row];
      for (int row = kSize - 1; row >= 0; --row) pass_up(x, row);
      for (int row = 0; row < kSize; ++row) pass_down(x, row);
    }
  }

 private:
  struct Pivots {
    S least, sum;
    void count(S d) noexcept {
      least = d < least ? d : least;
      sum += d;
    }
  };
  /// The unknowns between a row's own and the root: the columns of its entries beside the diagonal.
  template <int kRow>
  static constexpr auto kAbove = [] {
    std::array<std::size_t, static_cast<std::size_t>(Pattern::length(kRow) - 1)> above{};
    int i = kRow;
    for (std::size_t& column : above) column = static_cast<std::size_t>(i = Pattern::parent(i));
    return above;
  }();
  template <int kRow>
  using Columns = std::make_index_sequence<kAbove<kRow>.size()>;

  static constexpr std::size_t at(int k, int i) noexcept { return static_cast<std::size_t>(Pattern::entry(k, i)); }

  void eliminate(const TreeMatrix<Tree, S>& H, S raise, Pivots& pivots, int row) noexcept {
    const auto length = static_cast<std::size_t>(Pattern::length(row));
    S* entries = &entries_[at(row, row)];
    for (std::size_t j = 0; j < length; ++j) entries[j] = H.entries[at(row, row) + j];
    entries[0] *= raise;
    for (int k = kSize - 1; k > row; --k) {
      if (Pattern::entry(k, row) < 0) continue;
      const S* behind = &entries_[at(k, row)];  // goes on to the root as this row does
      const S l = behind[0] * entries_[at(k, k)];
      for (std::size_t j = 0; j < length; ++j) entries[j] -= l * behind[j];
    }
    pivots.count(entries[0]);
    entries[0] = S(1) / entries[0];
  }
  void pass_up(S* x, int row) const noexcept {
    const S* entries = &entries_[at(row, row)];
    x[row] *= *entries;
    for (int i = Pattern::parent(row); i >= 0; i = Pattern::parent(i)) x[i] -= *++entries * x[row];
  }
  void pass_down(S* x, int row) const noexcept {
    const S* entries = &entries_[at(row, row)];
    const S inverse_d = *entries;
    S sum{};
    for (int i = Pattern::parent(row); i >= 0; i = Pattern::parent(i)) sum += *++entries * x[i];
    x[row] -= inverse_d * sum;
  }

  // The same, forced into its caller, where row and column are constants and a row stays in registers.
  template <int... k>
  [[gnu::always_inline]] void eliminate_straight(const TreeMatrix<Tree, S>& H, S raise, Pivots& pivots,
                                                 std::integer_sequence<int, k...>) noexcept {
    (eliminate<kSize - 1 - k>(H, raise, pivots, Columns<kSize - 1 - k>{}), ...);
  }
  template <int kRow, std::size_t... j>
  [[gnu::always_inline]] void eliminate(const TreeMatrix<Tree, S>& H, S raise, Pivots& pivots,
                                        std::index_sequence<j...>) noexcept {
    constexpr std::size_t kFirst = at(kRow, kRow);
    std::array<S, sizeof...(j) + 1> row{H.entries[kFirst] * raise, H.entries[kFirst + 1 + j]...};
    subtract_all<kRow>(row, std::make_integer_sequence<int, kSize - 1 - kRow>{});
    pivots.count(row[0]);
    entries_[kFirst] = S(1) / row[0];
    ((entries_[kFirst + 1 + j] = row[j + 1]), ...);
  }
  template <int kRow, std::size_t kLength, int... k>
  [[gnu::always_inline]] void subtract_all(std::array<S, kLength>& row, std::integer_sequence<int, k...>) noexcept {
    (subtract<kRow, kSize - 1 - k>(row, std::make_index_sequence<kLength>{}), ...);
  }
  template <int kRow, int k, std::size_t... j>
  [[gnu::always_inline]] void subtract(std::array<S, sizeof...(j)>& row, std::index_sequence<j...>) noexcept {
    if constexpr (Pattern::entry(k, kRow) >= 0) {
      const S l = entries_[at(k, kRow)] * entries_[at(k, k)];
      ((row[j] -= l * entries_[at(k, kRow) + j]), ...);
    }
  }
  template <int... k>
  [[gnu::always_inline]] void solve_straight(const S* b, S* x, std::integer_sequence<int, k...>) const noexcept {
    std::array<S, static_cast<std::size_t>(kSize)> y{b[k]...};
    (pass_up<kSize - 1 - k>(y.data(), Columns<kSize - 1 - k>{}), ...);
    (pass_down<k>(y.data(), Columns<k>{}), ...);
    ((x[k] = y[k]), ...);
  }
  template <int kRow, std::size_t... j>
  [[gnu::always_inline]] void pass_up(S* x, std::index_sequence<j...>) const noexcept {
    const S y = x[kRow] * entries_[at(kRow, kRow)];
    ((x[kAbove<kRow>[j]] -= entries_[at(kRow, kRow) + 1 + j] * y), ...);
    x[kRow] = y;
  }
  template <int kRow, std::size_t... j>
  [[gnu::always_inline]] void pass_down(S* x, std::index_sequence<j...>) const noexcept {
    if constexpr (sizeof...(j) > 0) {
      x[kRow] -= entries_[at(kRow, kRow)] * (... + (entries_[at(kRow, kRow) + 1 + j] * x[kAbove<kRow>[j]]));
    }
  }

  std::array<S, static_cast<std::size_t>(Pattern::kEntries)> entries_;
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
    factor.solve(x.data(), x.data());
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
