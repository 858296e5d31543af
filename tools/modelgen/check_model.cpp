#include "tools/modelgen/check_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "core/model/model_table.hpp"

namespace articam::modelgen {
namespace {

void check_name(const std::string& file, int line, const char* kind, const std::string& name,
                Diagnostics& diagnostics) {
  const std::string_view reason = why_not_a_name(name);
  if (!reason.empty()) diagnostics.error(file, line, title(kind, name), fmt::format("the name {}", reason));
}

/// Names of one kind, with the line where each was first seen.
template <class Items>
std::map<std::string, int> check_unique(const std::string& file, const char* kind, const Items& items,
                                        Diagnostics& diagnostics) {
  std::map<std::string, int> first_line;
  for (const auto& item : items) {
    if (item.name.empty()) continue;  // already reported
    check_name(file, item.line, kind, item.name, diagnostics);
    const auto [seen, inserted] = first_line.emplace(item.name, item.line);
    if (inserted) continue;
    diagnostics.error(file, item.line, title(kind, item.name),
                      fmt::format("the name is taken since line {}; rename one", seen->second));
  }
  return first_line;
}

void settle_limits(const std::string& file, UrdfJoint& joint, Diagnostics& diagnostics) {
  const std::string joint_title = title("joint", joint.name);
  const auto unlimited = [&](int line, const char* reason) {
    joint.lower = -model::kUnlimited;
    joint.upper = model::kUnlimited;
    if (reason != nullptr) diagnostics.warning(file, line, joint_title, reason);
  };
  if (joint.type == JointType::continuous) {
    unlimited(joint.limit_line, joint.has_limit ? "limits of a continuous joint are ignored" : nullptr);
  } else if (!joint.has_limit) {
    unlimited(joint.line, "no <limit lower=\"..\" upper=\"..\"/>: taken as unlimited");
  } else if (joint.lower > joint.upper) {
    unlimited(joint.limit_line, "lower is above upper: taken as unlimited");
  }
  joint.lower = std::clamp(joint.lower, -model::kUnlimited, model::kUnlimited);
  joint.upper = std::clamp(joint.upper, -model::kUnlimited, model::kUnlimited);
}

void check_joint(const std::string& file, UrdfJoint& joint, Diagnostics& diagnostics) {
  const std::string joint_title = title("joint", joint.name);
  if (!joint.moves()) return;
  if (std::hypot(joint.axis[0], joint.axis[1], joint.axis[2]) < kMinAxis) {
    diagnostics.error(file, joint.axis_line, joint_title, "the axis is zero; give its direction, e.g. xyz=\"0 0 1\"");
  }
  settle_limits(file, joint, diagnostics);
}

/// Joints join declared links, and no link hangs on two joints. Returns the joint above each link.
std::map<std::string, const UrdfJoint*> check_ends(UrdfModel& model, const std::map<std::string, int>& links,
                                                   Diagnostics& diagnostics) {
  std::map<std::string, const UrdfJoint*> above;
  for (const UrdfJoint& joint : model.joints) {
    const std::string joint_title = title("joint", joint.name);
    const auto check_end = [&](const std::string& link, int line, const char* end) {
      if (link.empty() || links.count(link) > 0) return;
      diagnostics.error(model.file, line, joint_title, fmt::format("{} link '{}' is not declared", end, link));
    };
    check_end(joint.parent, joint.parent_line, "parent");
    check_end(joint.child, joint.child_line, "child");
    if (joint.child.empty()) continue;
    if (joint.child == joint.parent) {
      diagnostics.error(model.file, joint.child_line, joint_title, "parent and child are the same link");
    }
    const auto [first, inserted] = above.emplace(joint.child, &joint);
    if (inserted) continue;
    diagnostics.error(model.file, joint.child_line, joint_title,
                      fmt::format("link '{}' already hangs on joint '{}'", joint.child, first->second->name));
  }
  return above;
}

/// One root, and every other link below it.
void check_tree(const UrdfModel& model, const std::map<std::string, const UrdfJoint*>& above,
                Diagnostics& diagnostics) {
  std::string root;
  for (const UrdfLink& link : model.links) {
    if (link.name.empty() || above.count(link.name) > 0) continue;
    if (root.empty()) {
      root = link.name;
    } else {
      diagnostics.error(model.file, link.line, title("link", link.name),
                        fmt::format("a second root beside '{}'; join it by a joint or remove it", root));
    }
  }
  for (const UrdfLink& link : model.links) {
    std::size_t steps = 0;
    auto joint = above.find(link.name);
    while (joint != above.end() && ++steps <= model.joints.size()) joint = above.find(joint->second->parent);
    if (steps <= model.joints.size()) continue;
    diagnostics.error(model.file, link.line, title("link", link.name), "hangs on a cycle of joints; cut the cycle");
  }
  if (model.links.empty()) diagnostics.error(model.file, model.line, "robot", "has no links");
}

void check_markers(const MarkersFile& markers, const ModelOptions& options, const std::map<std::string, int>& links,
                   Diagnostics& diagnostics) {
  std::set<std::string> names;
  const auto check = [&](const std::string& file, const Marker& marker, const char* kind) {
    if (marker.frame.empty()) return;  // already reported
    const std::string marker_title = title(kind, marker.name);
    if (links.count(marker.frame) == 0) {
      diagnostics.error(file, marker.line, marker_title, fmt::format("the URDF has no link '{}'", marker.frame));
    }
    if (!names.insert(marker.name).second) {
      diagnostics.error(file, marker.line, marker_title, "is given twice; each marker needs its own link and name");
    }
  };
  for (const Marker& marker : markers.markers) check(markers.file, marker, "marker");
  for (const Marker& point : options.points) {
    check_name("--poi", 0, "point", point.name, diagnostics);
    check("--poi", point, "point");
  }
}

}  // namespace

void check_model(UrdfModel& model, const MarkersFile& markers, const ModelOptions& options, Diagnostics& diagnostics) {
  if (model.robot.empty()) {
    model.robot = "unnamed";
    diagnostics.warning(model.file, model.line, "robot", "has no name: taken as 'unnamed'");
  }
  check_name(model.file, model.line, "robot", model.robot, diagnostics);
  auto links = check_unique(model.file, "link", model.links, diagnostics);
  check_unique(model.file, "joint", model.joints, diagnostics);
  const auto on_world = [](const UrdfJoint& joint) { return joint.parent == "world"; };
  const auto joint = std::find_if(model.joints.begin(), model.joints.end(), on_world);
  if (joint != model.joints.end() && links.count("world") == 0) {
    model.links.push_back({"world", joint->parent_line});
    links.emplace("world", joint->parent_line);
    diagnostics.warning(model.file, joint->parent_line, title("joint", joint->name),
                        "parent link 'world' is not declared: added");
  }
  for (UrdfJoint& each : model.joints) check_joint(model.file, each, diagnostics);
  check_tree(model, check_ends(model, links, diagnostics), diagnostics);
  check_markers(markers, options, links, diagnostics);
  if (!options.root.empty() && links.count(options.root) == 0) {
    diagnostics.error("--root", 0, title("link", options.root), "the URDF has no such link");
  }
}

}  // namespace articam::modelgen
