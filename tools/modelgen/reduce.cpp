#include "tools/modelgen/reduce.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/math/so3.hpp"
#include "core/math/trigonometry.hpp"
#include "tools/modelgen/check_start.hpp"
#include "tools/modelgen/prune.hpp"

namespace articam::modelgen {
namespace {

using Vec3 = Vec<double, 3>;

Vec3 unit_axis(const UrdfJoint& joint) { return Vec3(joint.axis[0], joint.axis[1], joint.axis[2]).normalized(); }

Vec3 rounded(const Vec3& v) {
  return v.unaryExpr([](double x) { return modelgen::rounded(x); });
}

/// Of the two quaternions of one rotation, the one whose first number that is not zero is positive.
Pose<double> rounded(const Pose<double>& pose) {
  const Quat<double> q = pose.R.normalized();
  Vec<double, 4> wxyz(q.w(), q.x(), q.y(), q.z());
  wxyz = wxyz.unaryExpr([](double x) { return modelgen::rounded(x); }).eval();
  const auto first = std::find_if(wxyz.begin(), wxyz.end(), [](double x) { return x != 0; });
  if (*first < 0) wxyz = wxyz.unaryExpr([](double x) { return x == 0 ? 0.0 : -x; }).eval();
  return {Quat<double>(wxyz[0], wxyz[1], wxyz[2], wxyz[3]), rounded(pose.t)};
}

model::JointKind kind_of(JointType type) {
  if (type == JointType::revolute) return model::JointKind::revolute;
  return type == JointType::continuous ? model::JointKind::continuous : model::JointKind::prismatic;
}

/// Where a link sits on its body.
struct Place {
  int body{-1};
  Pose<double> T_body_link;
};

/// Walks the tree from the chosen root, over joints in both directions.
class Walk {
 public:
  explicit Walk(const UrdfModel& model) : model_{model}, crossed_(model.joints.size()) {
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      joints_at_[model.joints[i].parent].push_back(i);
      joints_at_[model.joints[i].child].push_back(i);
    }
  }

  void visit(const std::string& link, const Place& place) {
    places[link] = place;
    for (const std::size_t i : joints_at_[link]) {
      const UrdfJoint& joint = model_.joints[i];
      if (crossed_[i]) continue;
      crossed_[i] = true;
      cross(joint, joint.parent == link, place);
    }
  }

  std::map<std::string, Place> places;
  std::vector<TableJoint> joints;

 private:
  void cross(const UrdfJoint& joint, bool downwards, const Place& from) {
    const std::string& to_link = downwards ? joint.child : joint.parent;
    Pose<double> T_parent_child = pose_of(joint.origin_xyz, joint.origin_rpy);
    if (joint.held)
      T_parent_child =
          T_parent_child * displacement(joint.type == JointType::prismatic, unit_axis(joint) * *joint.held);
    if (!joint.moves() || joint.held) {
      const Pose<double> T_from_to = downwards ? T_parent_child : T_parent_child.inverse();
      return visit(to_link, {from.body, from.T_body_link * T_from_to});
    }
    TableJoint row;
    row.name = joint.name;
    row.line = joint.line;
    row.child_link = to_link;
    row.kind = kind_of(joint.type);
    row.parent = from.body;
    // Downwards {joint} is the child link. Upwards the origin lies beyond the motion: T_child_parent(q) is the
    // motion by -q, then the inverse origin, which therefore places the parent link on the new body.
    row.axis = downwards ? unit_axis(joint) : Vec3(-unit_axis(joint));
    row.T_parent_joint = downwards ? from.T_body_link * T_parent_child : from.T_body_link;
    row.q_min = joint.lower;
    row.q_max = joint.upper;
    if (joint.mimics) {
      row.ratio = joint.ratio;
      row.offset = joint.offset;
    }
    if (!downwards) row.T_body_link = T_parent_child.inverse();
    joints.push_back(row);
    visit(to_link, {static_cast<int>(joints.size()) - 1, row.T_body_link});
  }

  const UrdfModel& model_;
  std::map<std::string, std::vector<std::size_t>> joints_at_;  ///< in the order of the URDF
  std::vector<bool> crossed_;
};

/// Leaders by row; a joint that mimics and its leader are both in the tree, so both have one.
void link_leaders(const UrdfModel& model, std::vector<TableJoint>& joints) {
  std::map<std::string, int> row_of;
  for (std::size_t i = 0; i < joints.size(); ++i) row_of[joints[i].name] = static_cast<int>(i);
  for (const UrdfJoint& joint : model.joints) {
    if (joint.mimics) joints[static_cast<std::size_t>(row_of.at(joint.name))].leader = row_of.at(joint.leader);
  }
}

std::string find_root(const UrdfModel& model) {
  std::set<std::string> children;
  for (const UrdfJoint& joint : model.joints) children.insert(joint.child);
  const auto is_child = [&](const UrdfLink& link) { return children.count(link.name) > 0; };
  return std::find_if_not(model.links.begin(), model.links.end(), is_child)->name;
}

TableMarker place_marker(const Marker& marker, const Place& place) {
  const Vec3 offset(marker.offset_m[0], marker.offset_m[1], marker.offset_m[2]);
  const Vec3 normal = (place.T_body_link.R * Vec3::UnitZ()).normalized();
  return {marker.name,
          marker.kind,
          place.body,
          rounded(place.T_body_link * offset),
          rounded(normal),
          marker.outer_diameter_m,
          marker.inner_diameter_m};
}

}  // namespace

double rounded(double x) {
  std::array<char, 400> text{};  // 309 digits before the point and 15 behind it
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed, 15).ptr;
  std::from_chars(text.data(), end, x);
  return x == 0 ? 0.0 : x;
}

Pose<double> pose_of(const std::array<double, 3>& xyz, const std::array<double, 3>& rpy) {
  const auto r = math::sin_cos(0.5 * rpy[0]), p = math::sin_cos(0.5 * rpy[1]), y = math::sin_cos(0.5 * rpy[2]);
  const Quat<double> yaw(y.cos, 0, 0, y.sin), pitch(p.cos, 0, p.sin, 0), roll(r.cos, r.sin, 0, 0);
  return {yaw * pitch * roll, Vec3(xyz[0], xyz[1], xyz[2])};
}

Pose<double> displacement(bool slides, const Vec3& step) {
  if (slides) return {Quat<double>::Identity(), step};
  return {math::exp_so3<double>(step), Vec3::Zero()};
}

Table reduce(const UrdfModel& model, const MarkersFile& markers, const ModelOptions& options,
             Diagnostics& diagnostics) {
  Table table;
  table.robot = model.robot;
  table.root_link = options.root.empty() ? find_root(model) : options.root;
  Walk walk(model);
  walk.visit(table.root_link, {});
  table.joints = std::move(walk.joints);
  link_leaders(model, table.joints);
  for (const Marker& marker : markers.markers) table.markers.push_back(place_marker(marker, walk.places[marker.frame]));
  for (const Marker& point : options.points) table.markers.push_back(place_marker(point, walk.places[point.frame]));
  for (const UrdfJoint& joint : model.joints) {
    if (joint.held) table.frozen.push_back({joint.name, *joint.held});
  }
  prune(table, model.file, diagnostics);
  for (TableJoint& joint : table.joints) {
    joint.axis = rounded(joint.axis);
    joint.T_parent_joint = rounded(joint.T_parent_joint);
  }
  if (markers.q0) {
    table.q0 = *markers.q0;
    check_start(table, markers, diagnostics);
  }
  return table;
}

}  // namespace articam::modelgen
