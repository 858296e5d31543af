#pragma once
/// @file  Who may include whom.

#include <string_view>

#include "tests/architecture/source_tree.hpp"

namespace articam::architecture {

/// Every `#include` of one file that its floor does not allow. The path decides the floor; files that
/// belong to no floor (tests, scripts, words) are never at fault.
Violations check_includes(std::string_view path, std::string_view text);

}  // namespace articam::architecture
