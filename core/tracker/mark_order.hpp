#pragma once
/// @file  The order in which marks add up along a model's tree, and what they have in common, known at compile time.

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/model/body_places.hpp"

namespace articam::tracker {

/// Bodies are worked from the last to the root, so a body's turn comes after its children's.
template <class M>
struct MarkOrder {
  static constexpr std::size_t kNumBodies = M::kJoints.size(), kNumMarkers = M::kMarkers.size();
  static constexpr bool kHasMimics = model::kNumBodies<M> != model::kNumJoints<M>;

  /// All joints in one chain, each with a value of its own: every two of them share a mark.
  static constexpr bool kIsChain = [] {
    for (std::size_t i = 0; i < kNumBodies; ++i) {
      if (M::kJoints[i].parent + 1 != static_cast<int>(i)) return false;
    }
    return !kHasMimics;
  }();

  /// kSlot[body + 1]: which sum collects the body's marks. A body goes on with the sum of its last child, which is
  /// done with when the body's turn comes; so a chain needs one sum.
  static constexpr auto kSlot = [] {
    std::array<std::size_t, kNumBodies + 1> slot{};
    std::array<bool, kNumBodies + 1> begun{};
    std::size_t next = 0;
    for (std::size_t b = kNumBodies + 1; b-- > 0;) {
      if (!begun[b]) slot[b] = next++;
      if (b == 0) break;
      const auto parent = static_cast<std::size_t>(M::kJoints[b - 1].parent + 1);
      if (!begun[parent]) slot[parent] = slot[b], begun[parent] = true;
    }
    return slot;
  }();
  static constexpr std::size_t kNumSlots = [] {
    std::size_t most = 0;
    for (const std::size_t slot : kSlot) most = slot > most ? slot : most;
    return most + 1;
  }();

  /// The way a marker faces, and its size. Bodies that only slide against each other have the axes of the first of
  /// them.
  struct Facing {
    int body;
    std::array<double, 3> normal;  ///< or its opposite
    double diameter_m;
    bool operator==(const Facing&) const = default;
  };
  static constexpr auto kFacing = [] {
    std::array<Facing, kNumMarkers> facing{};
    for (std::size_t m = 0; m < facing.size(); ++m) {
      const model::MarkerRow& row = M::kMarkers[m];
      int body = row.body;
      math::Triple<double> n{row.normal[0], row.normal[1], row.normal[2]};
      while (body >= 0) {
        const model::JointRow& joint = M::kJoints[static_cast<std::size_t>(body)];
        if (joint.kind != model::JointKind::prismatic) break;
        n = model::constant_axes(joint.r_parent_joint_wxyz) * n;
        body = joint.parent;
      }
      const double leading = n.z != 0 ? n.z : n.y != 0 ? n.y : n.x;
      if (leading < 0) n = -n;
      facing[m] = {body, {n.x, n.y, n.z}, row.outer_diameter_m};
    }
    return facing;
  }();
  /// Markers of one body that face one way.
  struct Group {
    int body;
    std::size_t begin, size;  ///< in kSorted
    Facing facing;
    bool turns;  ///< faces another way than the group before
  };
  static constexpr bool is_like(std::size_t a, std::size_t b) noexcept {
    return M::kMarkers[a].body == M::kMarkers[b].body && kFacing[a] == kFacing[b];
  }
  /// Markers in the order of work: those of a group side by side, and bodies from the last to the root.
  static constexpr auto kSorted = [] {
    std::array<std::size_t, kNumMarkers> sorted{};
    for (std::size_t m = 0; m < kNumMarkers; ++m) sorted[m] = m;
    const auto first = [](std::size_t m) {
      for (std::size_t other = 0;; ++other) {
        if (is_like(other, m)) return other;
      }
    };
    std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
      const int body_a = M::kMarkers[a].body, body_b = M::kMarkers[b].body;
      if (body_a != body_b) return body_a > body_b;
      return first(a) != first(b) ? first(a) < first(b) : a < b;
    });
    return sorted;
  }();
  static constexpr std::size_t kNumGroups = [] {
    std::size_t n = 0;
    for (std::size_t i = 0; i < kNumMarkers; ++i) n += i == 0 || !is_like(kSorted[i - 1], kSorted[i]) ? 1 : 0;
    return n;
  }();
  static constexpr auto kGroups = [] {
    std::array<Group, kNumGroups> groups{};
    std::size_t begin = 0;
    for (std::size_t g = 0; g < kNumGroups; ++g) {
      const std::size_t marker = kSorted[begin];
      std::size_t size = 0;
      while (begin + size < kNumMarkers && is_like(kSorted[begin + size], marker)) ++size;
      const bool turns = g == 0 || !(kFacing[marker] == groups[g - 1].facing);
      groups[g] = {M::kMarkers[marker].body, begin, size, kFacing[marker], turns};
      begin += size;
    }
    return groups;
  }();
};

}  // namespace articam::tracker
