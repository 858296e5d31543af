#pragma once
/// @file  A checked model -> the rows of its table: only moving joints, parents first, markers on bodies.

#include <array>

#include "core/math/se3.hpp"
#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/model_options.hpp"
#include "tools/modelgen/read_markers.hpp"
#include "tools/modelgen/read_urdf.hpp"
#include "tools/modelgen/table.hpp"

namespace articam::modelgen {

/// Links joined by fixed and held joints become one body. Rows follow the tree depth first, joints of one
/// link in the order of the URDF. A joint above the chosen root is turned round: its axis changes sign, so
/// that its value keeps its meaning. Joints that move no marker are left out (see prune()). Computed numbers are
/// rounded (see rounded()). The model must have passed check_model and resolve_mimics.
/// Errors  those of check_start.
Table reduce(const UrdfModel& model, const MarkersFile& markers, const ModelOptions& options, Diagnostics& diagnostics);

/// To 15 decimals: a composed pose is no more exact than that (5e-16), and 0.1 stays 0.1, half a turn an exact
/// 0 or -1, where the arithmetic leaves 0.30000000000000004 or 6e-17. Never -0.
double rounded(double x);

/// T = the origin of a joint or link. rpy: fixed-axis roll, pitch, yaw, R = Rz(y) Ry(p) Rx(r).
Pose<double> pose_of(const std::array<double, 3>& xyz, const std::array<double, 3>& rpy);

/// A moving joint's frame displaced by axis times value, along or about it.
Pose<double> displacement(bool slides, const Vec<double, 3>& step);

}  // namespace articam::modelgen
