#include "tools/report/marks.hpp"

#include <cmath>
#include <cstddef>

#include "tools/modelgen/reduce.hpp"

namespace articam::report {
namespace {

std::size_t index(int row) { return static_cast<std::size_t>(row); }

/// Of every row, which joint value moves it.
std::vector<int> values_of_rows(const modelgen::Table& table) {
  std::vector<int> values;
  int next = 0;
  for (const auto& joint : table.joints) values.push_back(joint.leader < 0 ? next++ : -1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < 0) values[i] = values[index(table.joints[i].leader)];
  }
  return values;
}

Pose<double> parent_pose(const std::vector<Pose<double>>& T_obj_body, int parent) {
  return parent < 0 ? Pose<double>{} : T_obj_body[index(parent)];
}

bool slides(const modelgen::TableJoint& joint) { return joint.kind == model::JointKind::prismatic; }

/// Velocity of a point of {obj} per unit rate of the row's joint.
Vec3 velocity_by(const modelgen::TableJoint& joint, const Pose<double>& T_obj_joint, const Vec3& point) {
  const Vec3 axis = T_obj_joint.R * joint.axis;
  return slides(joint) ? axis : Vec3(axis.cross(point - T_obj_joint.t));
}

}  // namespace

std::vector<Pose<double>> place_bodies(const modelgen::Table& table, const VectorX& joints) {
  const std::vector<int> values = values_of_rows(table);
  std::vector<Pose<double>> T_obj_body;
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    const modelgen::TableJoint& joint = table.joints[i];
    const Vec3 step = joint.axis * (joint.ratio * joints[values[i]] + joint.offset);
    T_obj_body.push_back(parent_pose(T_obj_body, joint.parent) * joint.T_parent_joint *
                         modelgen::displacement(slides(joint), step));
  }
  return T_obj_body;
}

Marks place_marks(const modelgen::Table& table, const VectorX& joints) {
  const std::vector<int> values = values_of_rows(table);
  const std::vector<Pose<double>> T_obj_body = place_bodies(table, joints);
  Marks marks;
  for (const modelgen::TableMarker& marker : table.markers) {
    const Pose<double> T_obj_mark = parent_pose(T_obj_body, marker.body);
    const Vec3 centre = T_obj_mark * marker.t_body_m;
    marks.centre.push_back(centre);
    marks.normal.emplace_back(T_obj_mark.R * marker.normal);
    auto& velocity = marks.velocity.emplace_back(3, joints.size());
    velocity.setZero();
    for (int row = marker.body; row >= 0; row = table.joints[index(row)].parent) {
      const modelgen::TableJoint& joint = table.joints[index(row)];
      const Pose<double> T_obj_joint = parent_pose(T_obj_body, joint.parent) * joint.T_parent_joint;
      velocity.col(values[index(row)]) += joint.ratio * velocity_by(joint, T_obj_joint, centre);
    }
  }
  return marks;
}

Vec3 perpendicular(const Vec3& n) {
  const Vec3 axis = std::abs(n.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  return (axis - axis.dot(n) * n).normalized();
}

}  // namespace articam::report
