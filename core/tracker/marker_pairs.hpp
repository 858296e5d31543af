#pragma once
/// @file  Pairs of a model's markers, in the order in which they are worth being taken for two marks of a frame.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "core/model/forward_kinematics.hpp"
#include "core/model/joint_paths.hpp"

namespace articam::tracker {

/// A set of joint values, bit i for value i of q.
using JointSet = std::uint64_t;

/// The joint values that move one body against the other.
template <class M>
constexpr JointSet joints_between(int body, int other) noexcept {
  static_assert(model::kNumJoints<M> <= 64, "one bit for each joint value");
  JointSet joints = 0;
  for (int row = 0; row < model::kNumBodies<M>; ++row) {
    if (model::moves<M>(row, body) == model::moves<M>(row, other)) continue;
    joints |= JointSet{1} << model::kValueOfRow<M>[static_cast<std::size_t>(row)];
  }
  return joints;
}

/// Two markers between which at most one joint value moves.
struct MarkerPair {
  std::uint8_t a{}, b{};
  std::int8_t joint{-1};  ///< -1: they are fixed to each other
};

namespace detail {

template <class M>
constexpr bool is_pair(std::size_t a, std::size_t b) {
  const auto& x = M::kMarkers[a];
  const auto& y = M::kMarkers[b];
  return x.kind != model::MarkerKind::point && y.kind != model::MarkerKind::point &&
         std::popcount(joints_between<M>(x.body, y.body)) <= 1;
}

template <class M>
constexpr std::size_t count_pairs() {
  std::size_t n = 0;
  for (std::size_t b = 0; b < M::kMarkers.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) n += is_pair<M>(a, b) ? 1u : 0u;
  }
  return n;
}

/// Of two markers on one body; of others their distance says little, the joint being anywhere.
template <class M>
constexpr double distance2(const MarkerPair& pair) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = M::kMarkers[pair.a].t_body_m[i] - M::kMarkers[pair.b].t_body_m[i];
    sum += d * d;
  }
  return sum;
}

template <class M>
constexpr auto ordered_pairs() {
  static_assert(M::kMarkers.size() < 256, "indices of a byte");
  std::array<MarkerPair, count_pairs<M>()> pairs{};
  std::size_t n = 0;
  for (std::size_t b = 0; b < M::kMarkers.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!is_pair<M>(a, b)) continue;
      const JointSet joints = joints_between<M>(M::kMarkers[a].body, M::kMarkers[b].body);
      pairs[n++] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                    static_cast<std::int8_t>(joints == 0 ? -1 : std::countr_zero(joints))};
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const MarkerPair& x, const MarkerPair& y) {
    const bool x_fixed = x.joint < 0, y_fixed = y.joint < 0;
    if (x_fixed != y_fixed) return x_fixed;
    const int x_body = M::kMarkers[x.a].body, y_body = M::kMarkers[y.a].body;
    if (x_fixed && x_body != y_body) return x_body < y_body;
    if (x_fixed && distance2<M>(x) != distance2<M>(y)) return distance2<M>(x) > distance2<M>(y);
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  return pairs;
}

}  // namespace detail

/// Markers fixed to each other come first: on the root, then on the other bodies, far apart before near, since a long
/// line says more of a pose. Then those with a joint between them, whose value their distance has to give.
template <class M>
inline constexpr auto kMarkerPairs = detail::ordered_pairs<M>();

}  // namespace articam::tracker
