#pragma once
/// @file  Where the marks of a parsed model stand and how its joints move them. The sizes are known at run time only.

#include <vector>

#include "core/math/types.hpp"
#include "tools/modelgen/table.hpp"

namespace articam::report {

using Vec3 = Vec<double, 3>;
using VectorX = Eigen::VectorXd;
using MatrixX = Eigen::MatrixXd;

/// In {obj}; one entry a row of table.markers.
struct Marks {
  std::vector<Vec3> centre;                                        ///< m
  std::vector<Vec3> normal;                                        ///< outward, unit
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> velocity;  ///< of the centre, per unit rate of each joint value
};

/// Pose of every body in {obj}, in the order of table.joints. `joints` are the values, in the order of table.values().
std::vector<Pose<double>> place_bodies(const modelgen::Table& table, const VectorX& joints);

Marks place_marks(const modelgen::Table& table, const VectorX& joints);

/// Whether a camera can see it: a point of interest has no mark.
inline bool is_mark(const modelgen::TableMarker& marker) { return marker.kind != model::MarkerKind::point; }

/// A unit vector across a unit vector, along {obj}'s x where that goes.
Vec3 perpendicular(const Vec3& n);

}  // namespace articam::report
