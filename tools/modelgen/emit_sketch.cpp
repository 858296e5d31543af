#include "tools/modelgen/emit_sketch.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "tools/modelgen/emit_text.hpp"

namespace articam::modelgen {
namespace {

std::string markers(const Table& table, int body) {
  std::string names;
  for (const TableMarker& marker : table.markers) {
    if (marker.body == body) names += (names.empty() ? "" : ", ") + marker.name;
  }
  return names.empty() ? "" : "  [" + names + "]";
}

/// How a joint follows another: `, = 2 hinge + 0.1`.
std::string gear(const Table& table, const TableJoint& joint) {
  if (joint.leader < 0) return "";
  const std::string ratio = joint.ratio == 1 ? "" : number(joint.ratio) + ' ';
  const std::string offset =
      joint.offset == 0 ? "" : (joint.offset < 0 ? " - " : " + ") + number(std::abs(joint.offset));
  return fmt::format(", = {}{}{}", ratio, table.joints[static_cast<std::size_t>(joint.leader)].name, offset);
}

/// The branches below a body, one a line; `stem` is what runs on from the lines above.
std::string branches(const Table& table, int body, const std::string& stem) {
  std::vector<int> children;
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    if (table.joints[i].parent == body) children.push_back(static_cast<int>(i));
  }
  std::string text;
  for (const int child : children) {
    const TableJoint& joint = table.joints[static_cast<std::size_t>(child)];
    const bool last = child == children.back();
    const std::string branch =
        fmt::format("{}{} {} ({}{}) --> {}{}", stem, last ? "`--" : "|--", joint.name, word(joint.kind),
                    gear(table, joint), joint.child_link, markers(table, child));
    text += "//   " + comment(branch) + '\n' + branches(table, child, stem + (last ? "    " : "|   "));
  }
  return text;
}

}  // namespace

std::string sketch(const Table& table) {
  return "//   " + comment(table.root_link + markers(table, -1)) + '\n' + branches(table, -1, "");
}

}  // namespace articam::modelgen
