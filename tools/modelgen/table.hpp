#pragma once
/// @file  The rows of a header while they are made: core/model/model_table.hpp with names that own their text.

#include <string>
#include <vector>

#include "core/math/se3.hpp"
#include "core/model/model_table.hpp"

namespace articam::modelgen {

/// model::JointRow with names that own their text, and the link below the joint.
struct TableJoint {
  std::string name;
  int line{};  ///< in the URDF
  std::string child_link;
  Pose<double> T_body_link;  ///< of child_link; identity unless the joint was turned round by --root
  model::JointKind kind{};
  int parent{};         ///< row of the parent body's joint, -1 for the root
  Vec<double, 3> axis;  ///< unit vector in {joint}
  Pose<double> T_parent_joint;
  double q_min{}, q_max{};  ///< rad or m
  int leader{-1};           ///< row of the joint that it mimics
  double ratio{1}, offset{};
};

/// model::FrozenRow likewise.
struct TableFrozen {
  std::string name;
  double value{};
};

/// model::MarkerRow likewise.
struct TableMarker {
  std::string name;
  model::MarkerKind kind{};
  int body{};
  Vec<double, 3> t_body_m;
  Vec<double, 3> normal;
  double outer_diameter_m{}, inner_diameter_m{};
};

struct Table {
  std::string robot;
  std::string root_link;  ///< {obj}
  std::vector<TableJoint> joints;
  std::vector<TableMarker> markers;
  std::vector<TableFrozen> frozen;
  std::vector<double> q0;  ///< 7 + n numbers, or empty

  /// The rows with a value of their own, in the order of q.
  std::vector<const TableJoint*> values() const {
    std::vector<const TableJoint*> rows;
    for (const TableJoint& joint : joints) {
      if (joint.leader < 0) rows.push_back(&joint);
    }
    return rows;
  }
};

}  // namespace articam::modelgen
