#pragma once
/// @file  Findings as a person reads them.

#include <string>

#include "tools/identify/identify.hpp"

namespace articam::identify {

/// @param camera_file  for the sentences about it.
std::string to_text(const Findings& findings, const std::string& camera_file);

}  // namespace articam::identify
