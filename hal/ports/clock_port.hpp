#pragma once
/// @file  What the loop asks of a clock.

#include <concepts>

#include "core/timestamp.hpp"

namespace articam::hal {

///   now  monotonic: never smaller than what an earlier call returned.
template <class C>
concept ClockPort = requires(const C clock) {
  { clock.now() }
  noexcept->std::same_as<Timestamp>;
};

}  // namespace articam::hal
