#include "tools/identify/object.hpp"

#include <utility>

#include "core/math/so3.hpp"

namespace articam::identify {
namespace {

Vec3 to_vec(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// A joint's axis in {obj}, and the body that it moves.
struct Hinge {
  Vec3 axis, origin;
  Pose<double> T_obj_body;
};

Hinge turn(const model::JointRow& row, const Pose<double>& T_obj_parent, double position) {
  const auto& r = row.r_parent_joint_wxyz;
  const Pose<double> T = T_obj_parent * Pose<double>{{r[0], r[1], r[2], r[3]}, to_vec(row.t_parent_joint_m)};
  const Vec3 axis = to_vec(row.axis);
  const Vec3 step = position * axis;
  const Pose<double> moved = row.kind == model::JointKind::prismatic
                                 ? Pose<double>{Quat<double>::Identity(), step}
                                 : Pose<double>{math::exp_so3<double>(step), Vec3::Zero()};
  return {T.R * axis, T.t, T * moved};
}

}  // namespace

Object::Object(std::vector<model::JointRow> joints, std::vector<model::MarkerRow> markers)
    : joints_{std::move(joints)}, markers_{std::move(markers)}, value_of_row_(joints_.size()) {
  for (std::size_t row = 0; row < joints_.size(); ++row) {
    if (joints_[row].leader >= 0) continue;
    value_of_row_[row] = num_values();
    values_.push_back(joints_[row]);
  }
  for (std::size_t row = 0; row < joints_.size(); ++row) {
    if (joints_[row].leader >= 0) value_of_row_[row] = value_of_row_[static_cast<std::size_t>(joints_[row].leader)];
  }
}

std::vector<PlacedMarker> Object::place(const VectorXd& values, const VectorXd& displaced) const {
  std::vector<Hinge> hinges;
  for (std::size_t row = 0; row < joints_.size(); ++row) {
    const model::JointRow& joint = joints_[row];
    const double value = values[value_of_row_[row]];
    const Pose<double> parent =
        joint.parent < 0 ? Pose<double>{} : hinges[static_cast<std::size_t>(joint.parent)].T_obj_body;
    hinges.push_back(turn(joint, parent, joint.leader < 0 ? value : joint.ratio * value + joint.offset));
  }
  std::vector<PlacedMarker> placed;
  for (std::size_t m = 0; m < markers_.size(); ++m) {
    const model::MarkerRow& row = markers_[m];
    const Pose<double> body = row.body < 0 ? Pose<double>{} : hinges[static_cast<std::size_t>(row.body)].T_obj_body;
    Vec3 place = to_vec(row.t_body_m);
    if (displaced.size() > 0) place += displaced.segment<3>(static_cast<Eigen::Index>(3 * m));
    PlacedMarker marker{body * place, body.R * to_vec(row.normal), body.R.toRotationMatrix(),
                        Eigen::Matrix3Xd::Zero(3, num_values()), Eigen::Matrix3Xd::Zero(3, num_values())};
    for (int j = row.body; j >= 0; j = joints_[static_cast<std::size_t>(j)].parent) {
      const auto i = static_cast<std::size_t>(j);
      const double ratio = joints_[i].ratio;
      const Vec3& axis = hinges[i].axis;
      const bool slides = joints_[i].kind == model::JointKind::prismatic;
      marker.centre_by_value.col(value_of_row_[i]) +=
          ratio * (slides ? axis : Vec3(axis.cross(marker.centre - hinges[i].origin)));
      if (!slides) marker.normal_by_value.col(value_of_row_[i]) += ratio * axis.cross(marker.normal);
    }
    placed.push_back(std::move(marker));
  }
  return placed;
}

}  // namespace articam::identify
