#pragma once
/// @file  Whether a tracker can begin at the q0 of a markers file.

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/read_markers.hpp"
#include "tools/modelgen/table.hpp"

namespace articam::modelgen {

/// What needs no model, so that it is told with whatever else is wrong.
/// Errors    a q0 shorter than a pose, with numbers beyond kMaxCoordinate, whose quaternion is not one, or whose
///           base is not in front of the camera.
void check_start(const MarkersFile& markers, Diagnostics& diagnostics);

/// The rest, of a table that has the q0.
/// Warnings  a joint outside its limits.
/// Errors    a q0 of the wrong length.
void check_start(const Table& table, const MarkersFile& markers, Diagnostics& diagnostics);

}  // namespace articam::modelgen
