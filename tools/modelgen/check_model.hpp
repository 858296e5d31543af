#pragma once
/// @file  The parsed files -> a model that makes sense; every assumption is written into it and said.

#include <string_view>

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/model_options.hpp"
#include "tools/modelgen/read_markers.hpp"
#include "tools/modelgen/read_urdf.hpp"

namespace articam::modelgen {

/// After a check without errors the links form one tree, names are unique and fit for generated code, axes of
/// moving joints are not zero, and every moving joint has ordered limits (kUnlimited where it has none).
///
/// Warnings  a robot without a name ('unnamed'), the link `world` not declared (added), no limits or lower above
///           upper (unlimited), limits of a continuous joint (ignored).
/// Errors    whatever else breaks those rules.
void check_model(UrdfModel& model, const MarkersFile& markers, const ModelOptions& options, Diagnostics& diagnostics);

/// Why a text cannot name a joint, link or point: empty if it can.
std::string_view why_not_a_name(std::string_view text);

/// Whether a text can name the C++ type: CamelCase letters and digits.
bool is_type_name(std::string_view text);

}  // namespace articam::modelgen
