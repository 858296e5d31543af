#include "core/model/forward_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/model/joint_paths.hpp"
#include "tests/support/random_state.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using test::Arm;
using Matrix = Eigen::Matrix4d;

/// The same tree by homogeneous matrices, Rodrigues' formula and libm: nothing shared with the code under test.
Matrix body_matrix(int body, const Vec<double, 4>& joints) {
  if (body < 0) return Matrix::Identity();
  const auto& row = Arm::kJoints[static_cast<std::size_t>(body)];
  const auto& [w, x, y, z] = row.r_parent_joint_wxyz;
  Matrix joint = Matrix::Identity(), move = Matrix::Identity();
  joint.topLeftCorner<3, 3>() << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
      1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  joint.topRightCorner<3, 1>() << row.t_parent_joint_m[0], row.t_parent_joint_m[1], row.t_parent_joint_m[2];
  const Eigen::Vector3d axis{row.axis[0], row.axis[1], row.axis[2]};
  if (row.kind == model::JointKind::prismatic) {
    move.topRightCorner<3, 1>() = axis * joints[body];
  } else {
    Eigen::Matrix3d cross;
    cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    move.topLeftCorner<3, 3>() += std::sin(joints[body]) * cross + (1 - std::cos(joints[body])) * cross * cross;
  }
  return body_matrix(row.parent, joints) * joint * move;
}

TEST(ForwardKinematics, PlacesEveryMarkerWhereHomogeneousMatricesDo) {
  test::Random random{1};
  for (int i = 0; i < 100; ++i) {
    const Vec<double, 4> joints = random.vector<double, 4>(-3, 3);
    const auto k = model::forward_kinematics<Arm, double>(joints);
    const auto kf = model::forward_kinematics<Arm, float>(joints.cast<float>());
    for (std::size_t m = 0; m < Arm::kMarkers.size(); ++m) {
      const auto& row = Arm::kMarkers[m];
      const Matrix T = body_matrix(row.body, joints);
      const Eigen::Vector3d p =
          T.topLeftCorner<3, 3>() * model::detail::to_vec<double>(row.t_body_m) + T.topRightCorner<3, 1>();
      const Eigen::Vector3d n = T.topLeftCorner<3, 3>() * model::detail::to_vec<double>(row.normal);
      EXPECT_LT((k.markers[m].centre - p).norm(), 1e-14) << row.name;  // a few roundings over a reach of metres
      EXPECT_LT((k.markers[m].normal - n).norm(), 1e-14) << row.name;
      EXPECT_LT((kf.markers[m].centre.cast<double>() - p).norm(), 3e-6) << row.name;  // the same in float
    }
  }
}

TEST(ForwardKinematics, GivesTheTwistThatMovesTheMarkers) {
  test::Random random{2};
  constexpr double h = 1e-6;  // truncation h^2 and rounding 1e-16/h meet near 1e-10
  for (int i = 0; i < 50; ++i) {
    const Vec<double, 4> joints = random.vector<double, 4>(-2, 2);
    const auto k = model::forward_kinematics<Arm, double>(joints);
    for (int j = 0; j < 4; ++j) {
      const auto plus = model::forward_kinematics<Arm, double>(joints + h * Vec<double, 4>::Unit(j));
      const auto minus = model::forward_kinematics<Arm, double>(joints - h * Vec<double, 4>::Unit(j));
      const auto& twist = k.joint_twist[static_cast<std::size_t>(j)];
      for (std::size_t m = 0; m < Arm::kMarkers.size(); ++m) {
        const bool moved = model::moves<Arm>(j, Arm::kMarkers[m].body);
        const Vec<double, 3> velocity = (plus.markers[m].centre - minus.markers[m].centre) / (2 * h);
        const Vec<double, 3> expected = moved ? twist.velocity_of(k.markers[m].centre) : Vec<double, 3>::Zero().eval();
        EXPECT_LT((velocity - expected).norm(), 1e-9)
            << Arm::kMarkers[m].name << " by " << Arm::kJoints[static_cast<std::size_t>(j)].name;
        const Vec<double, 3> turn = (plus.markers[m].normal - minus.markers[m].normal) / (2 * h);
        const Vec<double, 3> turned = moved ? twist.angular.cross(k.markers[m].normal) : Vec<double, 3>::Zero().eval();
        EXPECT_LT((turn - turned).norm(), 1e-9) << Arm::kMarkers[m].name;
      }
    }
  }
}

TEST(ForwardKinematics, PutsAJointThatMimicsWhereItsLeaderSays) {
  test::Random random{4};
  for (int i = 0; i < 50; ++i) {
    const Vec<double, 2> joints = random.vector<double, 2>(-2, 2);  // rod, lid
    const double rod = joints[0], lid = joints[1];
    const auto geared = model::forward_kinematics<test::GearedArm, double>(joints);
    const auto plain = model::forward_kinematics<Arm, double>(Vec<double, 4>(-0.5 * lid + 0.2, rod, 2 * lid, lid));
    for (std::size_t m = 0; m < Arm::kMarkers.size(); ++m) {
      EXPECT_EQ(geared.markers[m].centre, plain.markers[m].centre) << Arm::kMarkers[m].name;
      EXPECT_EQ(geared.markers[m].normal, plain.markers[m].normal) << Arm::kMarkers[m].name;
    }
  }
}

TEST(ForwardKinematics, KnowsWhichJointsStandAboveABody) {
  EXPECT_FALSE(model::moves<Arm>(0, -1));
  EXPECT_TRUE(model::moves<Arm>(0, 2) && model::moves<Arm>(1, 2) && model::moves<Arm>(2, 2));
  EXPECT_FALSE(model::moves<Arm>(3, 2) || model::moves<Arm>(0, 3) || model::moves<Arm>(2, 1));
}

}  // namespace
}  // namespace articam
