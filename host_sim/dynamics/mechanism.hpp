#pragma once
/// @file  A robot or an object as rigid bodies on joints: what a URDF says of its mechanics.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/se3.hpp"
#include "core/model/model_table.hpp"

namespace articam::sim {

/// Values and rates of joints; no heap up to kMaxJoints.
inline constexpr int kMaxJoints = 12;
using JointVec = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxJoints, 1>;
using JointMat = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxJoints, kMaxJoints>;
/// A frame's motion by each joint value: 6 x nv, rows (vx vy vz wx wy wz).
using JointJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints>;
using Vec6 = Vec<double, 6>;  ///< (linear, angular): a twist, or a force and its moment
using Mat6 = Mat<double, 6, 6>;

/// A joint and the body below it. Units  m, rad, kg, N, s. {body} is {joint} moved by the joint's position.
struct MechanismJoint {
  std::string name;
  model::JointKind kind{};
  int parent{-1};  ///< row of the joint above, earlier than this one; -1: the root
  Vec<double, 3> axis{Vec<double, 3>::UnitX()};
  Pose<double> T_parent_joint;
  Mat6 inertia{Mat6::Zero()};  ///< of the body, about its frame's origin, written in {body}: momentum = inertia twist

  double q_min{-model::kUnlimited}, q_max{model::kUnlimited};
  double max_rate{model::kUnlimited};
  double max_effort{};        ///< N or N m that a motor gives; 0: the joint is passive
  double damping{};           ///< N s/m or N m s
  double friction{};          ///< N or N m, against any motion
  double rotor_inertia{};     ///< what the motor adds, seen at the joint
  int value{};                ///< index in q of the value that moves it: its own, or its leader's
  double ratio{1}, offset{};  ///< it stands at ratio q[value] + offset
};

/// A link: a frame fixed to the body below a joint.
struct MechanismLink {
  std::string name;
  int body{-1};
  Pose<double> T_body_link;
};

/// {root} is the frame of the first link of the tree.
struct Mechanism {
  std::vector<MechanismJoint> joints;
  std::vector<MechanismLink> links;
  std::vector<int> value_rows;  ///< the joint of each value of q: the one that mimics none

  int num_values() const noexcept { return static_cast<int>(value_rows.size()); }
  const MechanismJoint& of_value(int i) const noexcept {
    return joints[static_cast<std::size_t>(value_rows[static_cast<std::size_t>(i)])];
  }
  /// Throws std::invalid_argument where there is none of that name.
  const MechanismLink& link(std::string_view name) const;
};

/// The inertia of a body of that mass and centre (m, in the frame it is written in); `about_centre` has the same axes.
Mat6 spatial_inertia(double mass_kg, const Vec<double, 3>& centre_m, const Mat<double, 3, 3>& about_centre) noexcept;

}  // namespace articam::sim
