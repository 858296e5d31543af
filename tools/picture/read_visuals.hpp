#pragma once
/// @file  URDF text -> the boxes, cylinders and spheres that show its links.

#include <string>
#include <vector>

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/source_file.hpp"
#include "tools/picture/shape.hpp"

namespace articam::picture {

/// One <visual> of a link; meshes are never opened and leave nothing.
struct Visual {
  std::string link;
  Form form{};
  Pose<double> T_link_shape;
  Vec3 size;  ///< m, as in Shape
  Colour colour{0.7, 0.7, 0.7};
};

/// Warnings  meshes and other shapes, once for all.
/// Errors    a file that read_urdf refuses, numbers that are none, sizes that are not positive: told, and left out.
std::vector<Visual> read_visuals(const modelgen::SourceFile& urdf, modelgen::Diagnostics& diagnostics);

}  // namespace articam::picture
