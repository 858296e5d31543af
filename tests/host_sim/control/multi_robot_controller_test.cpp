#include "host_sim/control/multi_robot_controller.hpp"

#include <gtest/gtest.h>

#include "host_sim/scenarios/paper.hpp"
#include "tests/host_sim/paper_setting.hpp"

namespace articam::sim {
namespace {

MultiRobotController controller_of(const Setting& s, const ControlOptions& options = {}) {
  return {s.robot, s.object, s.grasp, s.T_obj_base, s.gravity_obj, s.posture, s.object_position, options};
}

Pose<double> hand_of(const MultiRobotController& controller, const Setting& s) {
  return s.T_obj_base * controller.robot().pose(s.grasp.hand);
}

TEST(MultiRobotController, MovesHandAndHandleAsOne) {
  const Setting setting = test::paper_setting();
  MultiRobotController controller = controller_of(setting);
  double position = setting.object_position;
  for (int i = 0; i < 1000; ++i) {  // 5 s
    controller.step({position, 0}, 0.15);
    position += ControlOptions{}.period_s * controller.object_rate();
    const Pose<double> hand = hand_of(controller, setting), handle = controller.object().pose(setting.grasp.handle);
    // The accelerations are integrated in steps of 5 ms, and what that misses is pulled in at 20 / s.
    ASSERT_LT((hand.t - handle.t).norm(), 5e-5) << i;
    ASSERT_LT(hand.R.angularDistance(handle.R), 2e-4) << i;
  }
  EXPECT_NEAR(position, 0.15, 1e-3);
  EXPECT_EQ(controller.failures(), 0);
}

TEST(MultiRobotController, IsTheSecondOrderLawOfEquation8WhereNoLimitBinds) {
  const Setting setting = test::paper_setting();
  ControlOptions options;
  MultiRobotController controller = controller_of(setting, options);
  double position = setting.object_position;
  for (int i = 0; i < 200; ++i) {
    const double error = position - 0.025;
    controller.step({position, 0}, 0.025);
    const double wanted = -2 * std::sqrt(options.stiffness) * controller.object_rate() - options.stiffness * error;
    // The posture weighs 1e-4 of this task and asks for up to 2 rad/s^2; the hand's force weighs less.
    EXPECT_NEAR(controller.solution()[7], wanted, 0.01 * std::abs(wanted) + 3e-4) << i;
    position += options.period_s * controller.object_rate();
  }
}

TEST(MultiRobotController, ObeysTheMotionOfBothAndEveryLimit) {
  const Setting setting = test::paper_setting();
  MultiRobotController controller = controller_of(setting);
  double position = setting.object_position;
  for (int i = 0; i < 1200; ++i) {
    const double target = i < 600 ? 0.3 : -0.05;  // far, then beyond the end of the slide
    const ServoCommand& command = controller.step({position, 0}, target);
    const QuadraticProgram& program = controller.program();
    EXPECT_LT((program.E * controller.solution() - program.e).norm(), 1e-7);
    EXPECT_GT((program.C * controller.solution() - program.c).minCoeff(), -1e-6);
    for (int j = 0; j < 7; ++j) {
      const MechanismJoint& joint = setting.robot.of_value(j);
      EXPECT_LE(std::abs(command.torque[j]), joint.max_effort + 1e-6);
      EXPECT_LE(std::abs(command.qdot[j]), joint.max_rate + 1e-6);
      EXPECT_GE(command.q[j], joint.q_min - 1e-6);
      EXPECT_LE(command.q[j], joint.q_max + 1e-6);
    }
    // The rate seen through the grasp lags the bound by what the grasp's correction adds: a hundredth.
    EXPECT_LE(std::abs(controller.object_rate()), 1.01 * ControlOptions{}.max_object_rate);
    position += ControlOptions{}.period_s * controller.object_rate();
    EXPECT_GT(position, -1e-3) << "the end of the slide is the end";
  }
  EXPECT_EQ(controller.failures(), 0);
}

TEST(MultiRobotController, StopsWhenNothingIsSeenForLong) {
  const Setting setting = test::paper_setting();
  MultiRobotController controller = controller_of(setting);
  for (int i = 0; i < 100; ++i) controller.step({setting.object_position, 0}, 0.2);
  EXPECT_GT(controller.object_rate(), 0.03);
  for (int i = 0; i < 400; ++i) controller.step({setting.object_position, 1}, 0.2);
  EXPECT_LT(std::abs(controller.object_rate()), 1e-3);
}

}  // namespace
}  // namespace articam::sim
