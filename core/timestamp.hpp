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
  return static_cast<double>(later.ns - earlier.ns) * 1e-9;
}

constexpr Timestamp from_seconds(double t_s) noexcept {
  return {static_cast<std::int64_t>(t_s * 1e9 + (t_s < 0 ? -0.5 : 0.5))};
}

}  // namespace articam
