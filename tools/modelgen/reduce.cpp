#include "tools/modelgen/reduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "core/math/so3.hpp"
#include "core/math/trigonometry.hpp"

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

/// {joint} displaced by q, in {joint}.
Pose<double> displacement(const UrdfJoint& joint, double q) {
  const Vec3 step = unit_axis(joint) * q;
  if (joint.type == JointType::prismatic) return {Quat<double>::Identity(), step};
  return {math::exp_so3<double>(step), Vec3::Zero()};
}

/// Where a link sits on its body.
struct Place {
  int body{-1};
  Pose<double> T_body_link;
};

/// Walks the tree from the chosen root, over joints in both directions.
class Walk {
 public:
  Walk(const UrdfModel& model, const ModelOptions& options) : model_{model}, crossed_(model.joints.size()) {
    for (const Freeze& freeze : options.freeze) frozen_[freeze.joint] = freeze.value;
  }

  void visit(const std::string& link, const Place& place) {
    places[link] = place;
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      const UrdfJoint& joint = model_.joints[i];
      if (crossed_[i] || (joint.parent != link && joint.child != link)) continue;
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
    const auto frozen = frozen_.find(joint.name);
    const bool held = frozen != frozen_.end();
    if (held) T_parent_child = T_parent_child * displacement(joint, frozen->second);
    if (!joint.moves() || held) {
      const Pose<double> T_from_to = downwards ? T_parent_child : T_parent_child.inverse();
      return visit(to_link, {from.body, from.T_body_link * T_from_to});
    }
    TableJoint row;
    row.name = joint.name;
    row.child_link = to_link;
    row.kind = kind_of(joint.type);
    row.parent = from.body;
    // Downwards {joint} is the child link. Upwards the origin lies beyond the motion: T_child_parent(q) is the
    // motion by -q, then the inverse origin, which therefore places the parent link on the new body.
    row.axis = downwards ? unit_axis(joint) : Vec3(-unit_axis(joint));
    row.T_parent_joint = downwards ? from.T_body_link * T_parent_child : from.T_body_link;
    row.q_min = joint.lower;
    row.q_max = joint.upper;
    joints.push_back(row);
    const int body = static_cast<int>(joints.size()) - 1;
    visit(to_link, {body, downwards ? Pose<double>{} : T_parent_child.inverse()});
  }

  const UrdfModel& model_;
  std::map<std::string, double> frozen_;
  std::vector<bool> crossed_;
};

std::string find_root(const UrdfModel& model) {
  const auto hangs = [&](const UrdfLink& link) {
    return std::any_of(model.joints.begin(), model.joints.end(), [&](auto& joint) { return joint.child == link.name; });
  };
  return std::find_if_not(model.links.begin(), model.links.end(), hangs)->name;
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

/// Leaves out joints that move no marker, and renumbers the rows.
void prune(Table& table, const std::string& file, Diagnostics& diagnostics) {
  if (table.markers.empty()) {
    diagnostics.warning(file, 0, "robot", "no markers and no points: nothing of it can be observed");
    return;
  }
  std::vector<bool> used(table.joints.size());
  for (const TableMarker& marker : table.markers) {
    for (int i = marker.body; i >= 0; i = table.joints[static_cast<std::size_t>(i)].parent) {
      used[static_cast<std::size_t>(i)] = true;
    }
  }
  std::vector<int> new_row(table.joints.size(), -1);
  const auto renumbered = [&](int row) { return row < 0 ? -1 : new_row[static_cast<std::size_t>(row)]; };
  std::vector<TableJoint> kept;
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    TableJoint& joint = table.joints[i];
    if (!used[i]) {
      diagnostics.warning(file, 0, fmt::format("joint '{}'", joint.name), "moves no marker: left out of the table");
      continue;
    }
    new_row[i] = static_cast<int>(kept.size());
    joint.parent = renumbered(joint.parent);
    kept.push_back(joint);
  }
  for (TableMarker& marker : table.markers) marker.body = renumbered(marker.body);
  table.joints = std::move(kept);
}

void check_q0(const Table& table, const MarkersFile& markers, Diagnostics& diagnostics) {
  const auto& q0 = table.q0;
  if (q0.size() != 7 + table.joints.size()) {
    std::string order = "px py pz qw qx qy qz";
    for (const TableJoint& joint : table.joints) order += ' ' + joint.name;
    diagnostics.error(markers.file, markers.q0_line, "q0",
                      fmt::format("has {} numbers instead of {}: {}", q0.size(), 7 + table.joints.size(), order));
    return;
  }
  const auto refuse = [&](const std::string& reason) {
    diagnostics.error(markers.file, markers.q0_line, "q0", reason);
  };
  const auto far = [](double x) { return std::abs(x) > kMaxCoordinate; };
  if (std::any_of(q0.begin(), q0.end(), far)) return refuse(fmt::format("a number is beyond {:g}", kMaxCoordinate));
  if (!(q0[2] > 0)) refuse("pz is not positive: the base is not in front of the camera");
  const double norm = std::sqrt(q0[3] * q0[3] + q0[4] * q0[4] + q0[5] * q0[5] + q0[6] * q0[6]);
  if (!(std::abs(norm - 1) < 0.01)) {  // a start is typed with two or three digits
    refuse(fmt::format("its quaternion has norm {:.4g}, not 1", norm));
  }
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    const TableJoint& joint = table.joints[i];
    if (q0[7 + i] >= joint.q_min && q0[7 + i] <= joint.q_max) continue;
    diagnostics.warning(markers.file, markers.q0_line, "q0", fmt::format("{} is outside its limits", joint.name));
  }
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

Table reduce(const UrdfModel& model, const MarkersFile& markers, const ModelOptions& options,
             Diagnostics& diagnostics) {
  Table table;
  table.robot = model.robot;
  table.root_link = options.root.empty() ? find_root(model) : options.root;
  Walk walk(model, options);
  walk.visit(table.root_link, {});
  table.joints = std::move(walk.joints);
  for (const Marker& marker : markers.markers) table.markers.push_back(place_marker(marker, walk.places[marker.frame]));
  for (const Marker& point : options.points) table.markers.push_back(place_marker(point, walk.places[point.frame]));
  prune(table, model.file, diagnostics);
  for (TableJoint& joint : table.joints) {
    joint.axis = rounded(joint.axis);
    joint.T_parent_joint = rounded(joint.T_parent_joint);
  }
  if (markers.q0) {
    table.q0 = *markers.q0;
    check_q0(table, markers, diagnostics);
  }
  return table;
}

}  // namespace articam::modelgen
