#pragma once
/// @file  A URDF whose identified joints stand still.

#include <optional>
#include <string>
#include <vector>

#include "tools/identify/identify.hpp"
#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/read_urdf.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::identify {

/// The same text with each joint of `lengths` fixed where it was found, value and deviation in a comment inside, and so
/// whatever mimics it. Other comments stay; blanks and line ends are made anew.
/// @param model  what modelgen::compile_model made of the source: mimics resolved.
/// Errors  a joint that is a part of a planar or floating one, which the URDF cannot fix alone.
std::optional<std::string> freeze_joints(const modelgen::SourceFile& source, const modelgen::UrdfModel& model,
                                         const std::vector<Length>& lengths, modelgen::Diagnostics& diagnostics);

}  // namespace articam::identify
