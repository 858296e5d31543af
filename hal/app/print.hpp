#pragma once
/// @file  Text for a person, on standard output.

#include <string>

namespace articam::app {

/// Returns why not, or nothing.
std::string print(const std::string& text);

}  // namespace articam::app
