#pragma once
/// @file  Estimates -> lines for a person.

#include <string>

#include "tools/listen/output.hpp"

namespace articam::listen {

/// Time since the session's first estimate, frame, status and its reason, joints, place of the object, markers,
/// residual and age. Joints are in rad or m, whatever their kind: the link does not tell it.
std::string line(const Heard& heard);

/// To standard output.
class LineOutput : public Output {
 public:
  std::string take(const Heard& heard) override;
};

}  // namespace articam::listen
