#pragma once
/// @file  Small objects with dots, written on the spot.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "tests/tools/modelgen/compile_text.hpp"
#include "tools/report/placement.hpp"

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

inline std::string read(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The URDF with a link for one more mark, as the report tells a person to write it.
inline std::string glue(std::string urdf, const Candidate& candidate) {
  const Vec3 &p = candidate.place, &n = candidate.normal;
  const auto text = [](double x, double y, double z) {
    std::ostringstream stream;
    stream.precision(17);
    stream << x << ' ' << y << ' ' << z;
    return stream.str();
  };
  const std::string rpy = text(-std::asin(std::clamp(n.y(), -1.0, 1.0)), std::atan2(n.x(), n.z()), 0);
  return urdf.insert(urdf.rfind("</robot>"), dot("one_more", candidate.link, text(p.x(), p.y(), p.z()), rpy));
}

/// The markers file with it, in front; a q0 would still fit.
inline std::string glue_marker(std::string markers, const modelgen::TableMarker& mark) {
  std::ostringstream row;
  row.precision(17);
  row << "\n  - {frame: one_more, type: ";
  if (mark.kind == model::MarkerKind::ring) {
    row << "ring, outer_diameter_m: " << mark.outer_diameter_m << ", inner_diameter_m: " << mark.inner_diameter_m;
  } else {
    const bool light = mark.kind == model::MarkerKind::dot_light_on_dark;
    row << "dot, diameter_m: " << mark.outer_diameter_m
        << ", polarity: " << (light ? "light_on_dark" : "dark_on_light");
  }
  return markers.insert(markers.find("markers:") + 8, row.str() + "}");
}

}  // namespace articam::report::test
