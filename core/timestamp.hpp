#pragma once
/// @file  A point on the monotonic clock, and the span between two.

#include <compare>
#include <cstdint>

namespace articam {

/// Nanoseconds since the clock's own start; never wall time.
struct Timestamp {
  std::int64_t ns{};
  constexpr auto operator<=>(const Timestamp&) const noexcept = default;
};

/// later - earlier, in seconds. Exact to 1 ns for spans under 104 days (2^53 ns).
constexpr double seconds_between(Timestamp earlier, Timestamp later) noexcept {
  // Through unsigned: stamps of a broken clock may be farther apart than an int64 holds.
  const auto span = static_cast<std::uint64_t>(later.ns) - static_cast<std::uint64_t>(earlier.ns);
  return static_cast<double>(static_cast<std::int64_t>(span)) * 1e-9;
}

constexpr Timestamp from_seconds(double t_s) noexcept {
  return {static_cast<std::int64_t>(t_s * 1e9 + (t_s < 0 ? -0.5 : 0.5))};
}

}  // namespace articam
