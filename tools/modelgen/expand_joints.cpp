#include "tools/modelgen/expand_joints.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "core/math/types.hpp"
#include "core/model/model_table.hpp"

namespace articam::modelgen {
namespace {

using Vec3 = Vec<double, 3>;

struct Part {
  std::string_view name;
  JointType type;
  Vec3 axis;
};

/// The shortest turn that brings z to the normal; half a turn about x where the normal is -z.
Quat<double> turn_from_z(const Vec3& normal) {
  const Quat<double> R(1 + normal.z(), -normal.y(), normal.x(), 0);
  return R.norm() > kMinAxis ? R.normalized() : Quat<double>(0, 1, 0, 0);
}

std::vector<Part> planar_parts(const Vec3& normal) {
  const Quat<double> R = turn_from_z(normal);
  return {{"x", JointType::prismatic, R * Vec3::UnitX()},
          {"y", JointType::prismatic, R * Vec3::UnitY()},
          {"theta", JointType::continuous, normal}};
}

std::vector<Part> floating_parts() {
  return {{"x", JointType::prismatic, Vec3::UnitX()},      {"y", JointType::prismatic, Vec3::UnitY()},
          {"z", JointType::prismatic, Vec3::UnitZ()},      {"yaw", JointType::continuous, Vec3::UnitZ()},
          {"pitch", JointType::continuous, Vec3::UnitY()}, {"roll", JointType::continuous, Vec3::UnitX()}};
}

/// The parts in a row from the joint's parent to its child; the first has the joint's origin.
void put_parts(const UrdfJoint& joint, const std::vector<Part>& parts, UrdfModel& model) {
  UrdfJoint row = joint;
  for (const Part& part : parts) {
    const bool last = &part == &parts.back();
    row.name = fmt::format("{}.{}", joint.name, part.name);
    row.type = part.type;
    row.axis = {part.axis.x(), part.axis.y(), part.axis.z()};
    row.has_limit = part.type == JointType::prismatic;
    row.lower = -model::kUnlimited;
    row.upper = model::kUnlimited;
    row.child = last ? joint.child : row.name;
    if (!last) model.links.push_back({row.name, joint.line});
    model.joints.push_back(row);
    row.parent = row.name;
    row.origin_xyz = row.origin_rpy = {};
  }
}

}  // namespace

void expand_joints(UrdfModel& model, Diagnostics& diagnostics) {
  std::vector<UrdfJoint> written = std::exchange(model.joints, {});
  for (UrdfJoint& joint : written) {
    const Vec3 axis(joint.axis[0], joint.axis[1], joint.axis[2]);
    const bool planar = joint.type == JointType::planar && axis.norm() > kMinAxis;
    if (!planar && joint.type != JointType::floating) {
      model.joints.push_back(joint);
      continue;
    }
    const std::string joint_title = title("joint", joint.name);
    if (joint.mimics) {
      diagnostics.error(model.file, joint.mimic_line, joint_title,
                        "a planar or floating joint cannot mimic; remove <mimic>");
      joint.mimics = false;
    }
    if (joint.has_limit) {
      diagnostics.warning(model.file, joint.limit_line, joint_title,
                          "limits of a planar or floating joint are ignored");
    }
    put_parts(joint, planar ? planar_parts(axis.normalized()) : floating_parts(), model);
  }
}

}  // namespace articam::modelgen
