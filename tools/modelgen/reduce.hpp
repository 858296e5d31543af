#pragma once
/// @file  A checked model -> the rows of its table: only moving joints, parents first, markers on bodies.

#include <array>
#include <string>
#include <vector>

#include "core/math/se3.hpp"
#include "core/model/model_table.hpp"
#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/model_options.hpp"
#include "tools/modelgen/read_markers.hpp"
#include "tools/modelgen/read_urdf.hpp"

namespace articam::modelgen {

/// model::JointRow with names that own their text, and the link below the joint.
struct TableJoint {
  std::string name;
  std::string child_link;
  model::JointKind kind{};
  int parent{};         ///< row of the parent body's joint, -1 for the root
  Vec<double, 3> axis;  ///< unit vector in {joint}
  Pose<double> T_parent_joint;
  double q_min{}, q_max{};  ///< rad or m
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
  std::vector<double> q0;  ///< 7 + n numbers, or empty
};

/// Links joined by fixed and frozen joints become one body. Rows follow the tree depth first, joints of one
/// link in the order of the URDF. A joint above the chosen root is turned round: its axis changes sign, so
/// that its value keeps its meaning. Joints that move no marker are left out with a warning, unless there is no
/// marker at all. Computed numbers are rounded (see rounded()). The model must have passed check_model.
/// Errors  a q0 of the wrong length, with numbers beyond kMaxCoordinate, whose quaternion is not one, or whose base is
///         not in front of the camera.
Table reduce(const UrdfModel& model, const MarkersFile& markers, const ModelOptions& options, Diagnostics& diagnostics);

/// To 15 decimals: a composed pose is no more exact than that (5e-16), and 0.1 stays 0.1, half a turn an exact
/// 0 or -1, where the arithmetic leaves 0.30000000000000004 or 6e-17. Never -0.
double rounded(double x);

/// T = the origin of a joint or link. rpy: fixed-axis roll, pitch, yaw, R = Rz(y) Ry(p) Rx(r).
Pose<double> pose_of(const std::array<double, 3>& xyz, const std::array<double, 3>& rpy);

}  // namespace articam::modelgen
