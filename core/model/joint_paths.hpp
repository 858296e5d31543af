#pragma once
/// @file  Which joints move which bodies.

#include <array>
#include <cstddef>

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

}  // namespace articam::model
