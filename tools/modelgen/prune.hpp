#pragma once
/// @file  A table without the joints that say nothing about a marker.

#include <string>

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/table.hpp"

namespace articam::modelgen {

/// Leaves out joints that move no marker, unless there is no marker at all, and renumbers the rows. A leader that
/// moves none while a joint that mimics it does is kept for its value; where it stands matters to nobody, so its row
/// hangs on the root and keeps none of its ancestors.
/// Warnings  every joint left out or kept so; a model without any marker or point. `file` is the URDF's.
void prune(Table& table, const std::string& file, Diagnostics& diagnostics);

}  // namespace articam::modelgen
