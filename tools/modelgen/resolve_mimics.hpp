#pragma once
/// @file  Mimic joints and `--freeze` -> who moves with whom, and who stands still.

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/model_options.hpp"
#include "tools/modelgen/read_urdf.hpp"

namespace articam::modelgen {

/// Afterwards every joint that mimics names a leader that mimics none, chains multiplied out, or is held: at its
/// `--freeze`, or because its leader is held, is fixed, or moves it by nothing. A leader goes no further than the
/// limits of its followers let it, unless it is continuous.
///
/// Warnings  a leader's limits made narrower so, or a follower's that would leave it no room (ignored); mimic on a
///           fixed joint (ignored), of a fixed joint or by a multiplier of 0 (held at its offset); a frozen value
///           outside the joint's limits.
/// Errors    a leader that does not exist, a cycle, a chain that multiplies beyond kMaxCoordinate; `--freeze` of a
///           joint that does not exist, is fixed, mimics, or is named twice.
void resolve_mimics(UrdfModel& model, const ModelOptions& options, Diagnostics& diagnostics);

}  // namespace articam::modelgen
