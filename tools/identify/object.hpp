#pragma once
/// @file  A compiled model whose markers may stand elsewhere than its table says.

#include <Eigen/Core>

#include <string>
#include <vector>

#include "core/math/se3.hpp"
#include "core/model/model_table.hpp"

namespace articam::identify {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Vec3 = Vec<double, 3>;
using Mat3 = Mat<double, 3, 3>;

/// A marker of a configuration, and how the joint values move it. In {obj}.
struct PlacedMarker {
  Vec3 centre;  ///< m
  Vec3 normal;
  Mat3 R_obj_body;
  Eigen::Matrix3Xd centre_by_value, normal_by_value;  ///< a column for each joint value
};

/// The rows of a table, for what knows the model only at run time.
class Object {
 public:
  template <class Model>
  static Object of() {
    return {{Model::kJoints.begin(), Model::kJoints.end()}, {Model::kMarkers.begin(), Model::kMarkers.end()}};
  }
  Object(std::vector<model::JointRow> joints, std::vector<model::MarkerRow> markers);

  const std::vector<model::JointRow>& joints() const { return joints_; }
  const std::vector<model::MarkerRow>& markers() const { return markers_; }
  /// The row of each joint value.
  const std::vector<model::JointRow>& values() const { return values_; }
  int num_values() const { return static_cast<int>(values_.size()); }
  int num_markers() const { return static_cast<int>(markers_.size()); }

  /// Joint values, and what to add to each marker's place on its body (m, three numbers a marker; empty: nothing).
  std::vector<PlacedMarker> place(const VectorXd& values, const VectorXd& displaced) const;

 private:
  std::vector<model::JointRow> joints_;
  std::vector<model::MarkerRow> markers_;
  std::vector<model::JointRow> values_;
  std::vector<int> value_of_row_;
};

}  // namespace articam::identify
