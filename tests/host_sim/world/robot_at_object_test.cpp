#include "host_sim/world/robot_at_object.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/host_sim/paper_setting.hpp"

namespace articam::sim {
namespace {

WorldOptions still() {
  WorldOptions options;
  options.sway.position_m = options.sway.rotation_rad = {};
  return options;
}

/// Standing still needs the torque that bears the arm.
ServoCommand standing(const Setting& setting) {
  MultiRobotController controller{setting.robot,       setting.object,  setting.grasp,          setting.T_obj_base,
                                  setting.gravity_obj, setting.posture, setting.object_position};
  return controller.command();
}

TEST(RobotAtObject, StandsWhereItWasPut) {
  const Setting setting = test::paper_setting();
  RobotAtObject world{setting, still()};
  const ServoCommand command = standing(setting);
  for (int i = 0; i < 2000; ++i) world.step(command, 0);
  EXPECT_NEAR(world.t_s(), 2, 1e-12);
  EXPECT_EQ(world.object_position(), setting.object_position) << "friction holds the drawer";
  EXPECT_LT((world.robot_position() - setting.posture).norm(), 1e-6);
  EXPECT_LT(world.hand().offset_m.norm(), 1e-6);
  const Pose<double> seen = world.T_cam_obj(2), meant = PaperScenario::at(0).q.T_cam_obj;
  EXPECT_LT((seen.t - meant.t).norm() + seen.R.angularDistance(meant.R), 1e-12);
}

TEST(RobotAtObject, HasPlayThatTheHandsPoseDoesNotTell) {
  const Setting setting = test::paper_setting();
  RobotAtObject world{setting, still()};
  const MechanismLink& hand = setting.grasp.hand;
  // Pull: where the hand goes along -z of the drawer, that comes after half of the play.
  ServoCommand command = standing(setting);
  RigidBodyDynamics arm{setting.robot, Vec<double, 3>::Zero()};
  arm.update(setting.posture, JointVec::Zero(7));
  const Vec<double, 3> out_base = setting.T_obj_base.R.conjugate() * Vec<double, 3>{0, 0, -1};
  Vec6 twist;
  twist << out_base, Vec<double, 3>::Zero();
  const JointJacobian J = arm.jacobian(hand);
  const JointVec along = J.transpose() * (J * J.transpose()).lu().solve(twist);
  const double play_m = WorldOptions{}.fingers.play_m.z();
  for (int i = 0; i < 1000; ++i) {
    command.q += 0.00001 * along;  // 10 mm in a second
    world.step(command, 0);
    const double moved_m = world.object_position() - setting.object_position;
    EXPECT_TRUE(i >= 60 || moved_m == 0) << i;
  }
  const double hand_m = 0.01, moved_m = world.object_position() - setting.object_position;
  // The play's half, and a little of spring and servo: friction is 4 N, the spring 12 kN/m.
  EXPECT_LT(moved_m, hand_m - 0.5 * play_m);
  EXPECT_GT(moved_m, hand_m - 0.5 * play_m - 0.0015);
}

TEST(RobotAtObject, LosesEnergyToFrictionAndStopsAtTheEndOfTheSlide) {
  Setting setting = test::paper_setting();
  setting.object_position = 0.001;
  RobotAtObject world{setting, still()};
  ServoCommand command = standing(setting);
  command.qdot.setZero();
  command.q[3] += 0.1;  // pushes
  for (int i = 0; i < 3000; ++i) world.step(command, 0);
  EXPECT_GE(world.object_position(), 0);
  EXPECT_EQ(world.object_rate(), 0);
}

}  // namespace
}  // namespace articam::sim
