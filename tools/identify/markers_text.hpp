#pragma once
/// @file  A markers file with the places that a recording told.

#include <optional>
#include <string>
#include <vector>

#include "tools/identify/identify.hpp"
#include "tools/modelgen/read_markers.hpp"

namespace articam::identify {

/// @param R_body_link  of each marker's frame.
/// @param q0           to write instead of the file's own.
std::string markers_text(const modelgen::MarkersFile& file, const std::vector<MarkerPlace>& places,
                         const std::vector<Mat3>& R_body_link, const std::optional<std::vector<double>>& q0);

}  // namespace articam::identify
