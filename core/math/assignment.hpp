#pragma once
/// @file  The cheapest one-to-one pairing of rows and columns.

#include <array>
#include <cstddef>
#include <limits>

namespace articam::math {

/// Pairs every row with a column of its own so that the sum of the costs is least, or with none at the price `alone`.
///
/// cost(row, column) is asked for rows < num_rows and columns < num_columns; infinity forbids the pair.
/// Result  column of each row, -1 where it stays alone.
/// Work    num_rows^2 (num_columns + num_rows) steps at most.
/// Source  Shortest augmenting paths with potentials: Jonker & Volgenant, Computing 38, 1987.
template <std::size_t kMaxRows, std::size_t kMaxColumns, class S, class Cost>
std::array<int, kMaxRows> assign(std::size_t num_rows, std::size_t num_columns, S alone, Cost&& cost) noexcept {
  constexpr std::size_t kSlots = kMaxColumns + kMaxRows + 1;  // columns, one "alone" a row, and the path's root
  constexpr S kInfinity = std::numeric_limits<S>::infinity();
  const std::size_t slots = num_columns + num_rows;
  std::array<S, kMaxRows + 1> row_price{};
  std::array<S, kSlots> slot_price{};
  std::array<std::size_t, kSlots> row_of{};  // 1-based, 0 is free; slot 0 is the root
  std::array<std::size_t, kSlots> previous{};

  for (std::size_t row = 1; row <= num_rows; ++row) {
    std::array<S, kSlots> distance;
    distance.fill(kInfinity);
    std::array<bool, kSlots> done{};
    std::size_t slot = 0;
    row_of[0] = row;
    do {  // grow the tree of alternating paths by its nearest slot until that one is free
      done[slot] = true;
      const std::size_t i = row_of[slot];
      std::size_t nearest = 0;
      S shortest = kInfinity;
      for (std::size_t j = 1; j <= slots; ++j) {
        if (done[j]) continue;
        const S price = j <= num_columns ? cost(i - 1, j - 1) : (j - num_columns == i ? alone : kInfinity);
        const S length = price - row_price[i] - slot_price[j];
        if (length < distance[j]) distance[j] = length, previous[j] = slot;
        if (distance[j] < shortest) shortest = distance[j], nearest = j;
      }
      for (std::size_t j = 0; j <= slots; ++j) {
        if (done[j]) {
          row_price[row_of[j]] += shortest, slot_price[j] -= shortest;
        } else {
          distance[j] -= shortest;
        }
      }
      slot = nearest;  // never 0: the row's own "alone" slot is always within reach
    } while (row_of[slot] != 0);
    for (; slot != 0; slot = previous[slot]) row_of[slot] = row_of[previous[slot]];
  }

  std::array<int, kMaxRows> column_of;
  column_of.fill(-1);
  for (std::size_t j = 1; j <= num_columns; ++j) {
    if (row_of[j] != 0) column_of[row_of[j] - 1] = static_cast<int>(j) - 1;
  }
  return column_of;
}

}  // namespace articam::math
