#pragma once
/// @file  A number that tells one compiled model from another.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/model/model_table.hpp"

namespace articam::model {

/// FNV-1a, 64 bit, over bytes in a fixed order: the same on every machine, at compile time and at run time.
/// Source  Fowler, Noll, Vo, Eastlake, "The FNV non-cryptographic hash algorithm", IETF draft.
class Fnv1a {
 public:
  constexpr void put(std::uint64_t x) noexcept {
    for (int shift = 0; shift < 64; shift += 8) put_byte(static_cast<std::uint8_t>(x >> shift));
  }
  constexpr void put(double x) noexcept { put(std::bit_cast<std::uint64_t>(x)); }
  constexpr void put(std::string_view text) noexcept {
    put(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) put_byte(static_cast<std::uint8_t>(c));
  }
  template <std::size_t N>
  constexpr void put(const std::array<double, N>& numbers) noexcept {
    for (const double x : numbers) put(x);
  }
  constexpr std::uint64_t value() const noexcept { return hash_; }

 private:
  constexpr void put_byte(std::uint8_t byte) noexcept { hash_ = (hash_ ^ byte) * 0x100000001b3U; }

  std::uint64_t hash_{0xcbf29ce484222325U};
};

/// Hash of everything that decides what a configuration of M means: joints, markers, schema. Not of q0, which only
/// says where to begin.
template <Model M>
constexpr std::uint64_t table_hash() noexcept {
  Fnv1a hash;
  hash.put(static_cast<std::uint64_t>(kTableSchema));
  hash.put(std::string_view{M::kName});
  hash.put(static_cast<std::uint64_t>(M::kJoints.size()));
  for (const JointRow& joint : M::kJoints) {
    hash.put(joint.name);
    hash.put(static_cast<std::uint64_t>(joint.kind));
    hash.put(static_cast<std::uint64_t>(joint.parent + 1));
    hash.put(joint.axis);
    hash.put(joint.t_parent_joint_m);
    hash.put(joint.r_parent_joint_wxyz);
    hash.put(joint.q_min);
    hash.put(joint.q_max);
    hash.put(static_cast<std::uint64_t>(joint.leader + 1));
    hash.put(joint.ratio);
    hash.put(joint.offset);
  }
  for (const MarkerRow& marker : M::kMarkers) {
    hash.put(marker.name);
    hash.put(static_cast<std::uint64_t>(marker.kind));
    hash.put(static_cast<std::uint64_t>(marker.body + 1));
    hash.put(marker.t_body_m);
    hash.put(marker.normal);
    hash.put(marker.outer_diameter_m);
    hash.put(marker.inner_diameter_m);
  }
  return hash.value();
}

}  // namespace articam::model
