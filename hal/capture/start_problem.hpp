#pragma once
/// @file  Why a capture does not start.

#include <string>

#include "core/status.hpp"

namespace articam::hal {

/// Thrown while a capture is being set up, never while it runs; the camera's start() catches it and says it.
struct StartProblem {
  Status status;
  std::string reason;
};

}  // namespace articam::hal
