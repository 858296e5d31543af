#pragma once
/// @file  What the loop asks of the way to the controller.

#include <concepts>

#include "core/status.hpp"

namespace articam::hal {

///   publish  one estimate, also when it says that there is none. Never blocks the loop for longer
///            than a write to a file or socket; io_error means that this estimate did not go out.
template <class L, class Estimate>
concept LinkPort = requires(L link, const Estimate& estimate) {
  { link.publish(estimate) }
  noexcept->std::same_as<Status>;
};

}  // namespace articam::hal
