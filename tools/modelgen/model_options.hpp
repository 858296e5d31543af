#pragma once
/// @file  What the command line asks of a model beyond its files: --root, --freeze, --poi.

#include <optional>
#include <string>
#include <vector>

#include "tools/modelgen/read_markers.hpp"

namespace articam::modelgen {

/// JOINT=VALUE: the joint is held there, as if it were fixed.
struct Freeze {
  std::string joint;
  double value{};  ///< rad or m
};

struct ModelOptions {
  std::string root;  ///< link that becomes {obj}; empty: the root of the URDF
  std::vector<Freeze> freeze;
  std::vector<Marker> points;  ///< NAME=LINK:x,y,z, all of MarkerKind::point
};

/// Nothing when the text does not have that form.
std::optional<Freeze> parse_freeze(const std::string& text);
std::optional<Marker> parse_point(const std::string& text);

}  // namespace articam::modelgen
