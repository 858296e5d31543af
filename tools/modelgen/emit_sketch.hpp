#pragma once
/// @file  The tree of a table as a drawing of comment lines.

#include <string>

#include "tools/modelgen/table.hpp"

namespace articam::modelgen {

///   // root  [markers]
///   // `-- joint (kind) --> link  [markers]
std::string sketch(const Table& table);

}  // namespace articam::modelgen
