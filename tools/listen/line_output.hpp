#pragma once
/// @file  Estimates -> lines for a person.

#include <string>

#include "tools/listen/output.hpp"

namespace articam::listen {

/// Time since the session's first estimate, frame, status and its reason, joints with their units, place of the
/// object, markers, residual and age. A board that does not tell the joints' kinds leaves the units open.
std::string line(const Heard& heard);

/// To standard output.
class LineOutput : public Output {
 public:
  std::string take(const Heard& heard) override;
};

}  // namespace articam::listen
