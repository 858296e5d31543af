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

/// A pair with what decides its rank, computed once: compilers bound the steps of a constant.
struct RankedPair {
  MarkerPair pair{};
  int body{};  ///< of both markers; 0 where a joint is between them, as their distance is
  double distance2_m2{};

  constexpr bool operator<(const RankedPair& other) const {
    const MarkerPair &x = pair, &y = other.pair;
    if ((x.joint < 0) != (y.joint < 0)) return x.joint < 0;
    if (body != other.body) return body < other.body;
    if (distance2_m2 != other.distance2_m2) return distance2_m2 > other.distance2_m2;
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  }
};

/// Of two markers on one body; of others their distance says little, the joint being anywhere.
template <class M>
constexpr double distance2(std::size_t a, std::size_t b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = M::kMarkers[a].t_body_m[i] - M::kMarkers[b].t_body_m[i];
    sum += d * d;
  }
  return sum;
}

template <class M>
constexpr auto ordered_pairs() {
  static_assert(M::kMarkers.size() < 256, "indices of a byte");
  std::array<RankedPair, count_pairs<M>()> ranked{};
  std::size_t n = 0;
  for (std::size_t b = 0; b < M::kMarkers.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!is_pair<M>(a, b)) continue;
      const JointSet joints = joints_between<M>(M::kMarkers[a].body, M::kMarkers[b].body);
      const bool fixed = joints == 0;
      ranked[n++] = {{static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                      static_cast<std::int8_t>(fixed ? -1 : std::countr_zero(joints))},
                     fixed ? M::kMarkers[a].body : 0,
                     fixed ? distance2<M>(a, b) : 0};
    }
  }
  std::sort(ranked.begin(), ranked.end());
  std::array<MarkerPair, count_pairs<M>()> pairs{};
  for (std::size_t i = 0; i < n; ++i) pairs[i] = ranked[i].pair;
  return pairs;
}

}  // namespace detail

/// Markers fixed to each other come first: on the root, then on the other bodies, far apart before near, since a long
/// line says more of a pose. Then those with a joint between them, whose value their distance has to give.
template <class M>
inline constexpr auto kMarkerPairs = detail::ordered_pairs<M>();

}  // namespace articam::tracker
