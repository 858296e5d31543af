#pragma once
/// @file  Which unknowns of an object have something to do with each other.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/model/model_table.hpp"

namespace articam::model {

namespace detail {

/// kMoves<M>[joint][body + 1]: whether the joint stands between the root and the body.
template <class M>
constexpr auto joints_above() {
  std::array<std::array<bool, M::kJoints.size() + 1>, M::kJoints.size() + 1> above{};
  for (int body = 0; body < kNumBodies<M>; ++body) {
    for (int joint = body; joint >= 0; joint = M::kJoints[static_cast<std::size_t>(joint)].parent) {
      above[static_cast<std::size_t>(joint)][static_cast<std::size_t>(body + 1)] = true;
    }
  }
  return above;
}
template <class M>
inline constexpr auto kMoves = joints_above<M>();

}  // namespace detail

/// Whether the joint of a row moves the markers of a body (-1: the root, which no joint moves).
template <class M>
constexpr bool moves(int joint, int body) noexcept {
  return detail::kMoves<M>[static_cast<std::size_t>(joint)][static_cast<std::size_t>(body + 1)];
}

/// The unknowns (t, rotation, joint values) as a tree: the base's six above all others, and two joint values on one
/// way to the root if they move a common marker, or come to be coupled when a later one is eliminated (which only
/// joints that mimic can bring about). See core/math/tree_factor.hpp.
template <class M>
struct UnknownTree {
  static constexpr std::size_t kSize = static_cast<std::size_t>(kDof<M>);
  static constexpr auto kParent = [] {
    std::array<std::array<bool, kSize>, kSize> coupled{};
    for (std::size_t i = 0; i < kSize; ++i) coupled[i].fill(i < 6);
    for (const MarkerRow& marker : M::kMarkers) {
      for (int j = 0; j < kNumBodies<M>; ++j) {
        for (int k = 0; k < kNumBodies<M>; ++k) {
          if (!moves<M>(j, marker.body) || !moves<M>(k, marker.body)) continue;
          const auto at = [](int row) {
            return static_cast<std::size_t>(6 + kValueOfRow<M>[static_cast<std::size_t>(row)]);
          };
          coupled[at(j)][at(k)] = true;
        }
      }
    }
    std::array<std::int16_t, kSize> parent{};
    for (std::size_t k = kSize; k-- > 0;) {
      parent[k] = static_cast<std::int16_t>(k < 6 ? static_cast<int>(k) - 1 : 5);
      for (std::size_t i = 6; i < k; ++i) {
        if (!coupled[k][i]) continue;
        parent[k] = static_cast<std::int16_t>(i);
        for (std::size_t j = 6; j < i; ++j) coupled[i][j] = coupled[i][j] || coupled[k][j];
      }
    }
    return parent;
  }();
};

}  // namespace articam::model
