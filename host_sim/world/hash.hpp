#pragma once
/// @file  Random bits that depend on nothing but a counter.

#include <cstdint>

namespace articam::sim {

/// 64 well-mixed bits of one counter value.
/// Source  Steele, Lea & Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014 (SplitMix64).
constexpr std::uint64_t hash(std::uint64_t counter) noexcept {
  std::uint64_t z = counter + 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// Numbers in sequence from a seed; each call moves on by one counter value.
class Dice {
 public:
  constexpr explicit Dice(std::uint64_t seed) noexcept : state_{hash(seed)} {}

  /// Uniform in [low, high).
  constexpr double between(double low, double high) noexcept {
    const double unit = static_cast<double>(hash(state_++) >> 11U) * 0x1p-53;
    return low + unit * (high - low);
  }

 private:
  std::uint64_t state_;
};

}  // namespace articam::sim
