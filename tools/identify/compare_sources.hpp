#pragma once
/// @file  A model's sources beside the table that a program was compiled with.

#include <string>
#include <vector>

#include "tools/identify/object.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/read_markers.hpp"
#include "tools/modelgen/table.hpp"

namespace articam::identify {

/// Empty, or what the table has otherwise than the object: then it comes from other sources.
std::string why_different(const Object& object, const modelgen::Table& table);

/// R_body_link of each marker's frame, which a table knows the normal of only. The sources must compile.
std::vector<Mat3> axes_of_frames(modelgen::CompileJob job, const modelgen::MarkersFile& markers);

}  // namespace articam::identify
