#pragma once
/// @file  Small objects with dots, written on the spot.

#include <string>

#include "tests/tools/modelgen/compile_text.hpp"

namespace articam::report::test {

inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& rest = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         rest + "</joint>";
}

/// A link of a dot, fixed to its parent.
inline std::string dot(const std::string& name, const std::string& parent, const std::string& xyz,
                       const std::string& rpy = "3.141592653589793 0 0") {
  return "<link name='" + name + "'/>" +
         joint(name + "_mount", "fixed", parent, name, "<origin xyz='" + xyz + "' rpy='" + rpy + "'/>");
}

inline std::string slide(const std::string& name, const std::string& parent, const std::string& child,
                         const std::string& axis) {
  return "<link name='" + child + "'/>" +
         joint(name, "prismatic", parent, child, "<axis xyz='" + axis + "'/><limit lower='0' upper='0.2'/>");
}

/// Dots on the links named, all of one size.
inline std::string dots(std::initializer_list<std::string> links) {
  std::string yaml = "markers:\n";
  for (const std::string& link : links) {
    yaml += "  - {frame: " + link + ", type: dot, diameter_m: 0.03, polarity: dark_on_light}\n";
  }
  return yaml;
}

inline modelgen::CompiledModel compile(const std::string& body, const std::string& markers) {
  return *modelgen::test::compile_text(modelgen::test::robot("<link name='base'/>" + body), markers).model;
}

}  // namespace articam::report::test
