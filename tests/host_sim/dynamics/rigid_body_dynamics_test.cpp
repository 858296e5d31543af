#include "host_sim/dynamics/rigid_body_dynamics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "host_sim/dynamics/read_mechanism.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"
#include "host_sim/world/hash.hpp"

namespace articam::sim {
namespace {

const Vec<double, 3> kGravity{0, 0, -9.81};

JointVec random_values(Dice& dice, int size, double reach) {
  JointVec values(size);
  for (double& value : values) value = dice.between(-reach, reach);
  return values;
}

/// 1/2 of the sum of v^T I v over the bodies, each twist found by differences of the pose of its link.
double kinetic_energy(const RigidBodyDynamics& arm, const JointVec& q, const JointVec& qdot) {
  RigidBodyDynamics at = arm;
  constexpr double kStep_s = 1e-6;
  double energy = 0;
  for (std::size_t row = 0; row < arm.mechanism().joints.size(); ++row) {
    const MechanismLink body{"", static_cast<int>(row), {}};
    at.update(q + kStep_s * qdot, qdot);
    const Pose<double> after = at.pose(body);
    at.update(q - kStep_s * qdot, qdot);
    const Pose<double> before = at.pose(body);
    at.update(q, qdot);
    const Quat<double> R_t = at.pose(body).R.conjugate();
    Vec6 twist;  // in {body}
    twist << R_t * Vec<double, 3>{(after.t - before.t) / (2 * kStep_s)},
        R_t * Vec<double, 3>{math::log_so3<double>(after.R * before.R.conjugate()) / (2 * kStep_s)};
    energy += 0.5 * twist.dot(arm.mechanism().joints[row].inertia * twist);
  }
  for (const MechanismJoint& joint : arm.mechanism().joints) {
    energy += 0.5 * joint.rotor_inertia * qdot[joint.value] * qdot[joint.value] * joint.ratio * joint.ratio;
  }
  return energy;
}

double potential_energy(const RigidBodyDynamics& arm) {
  double energy = 0;
  for (std::size_t row = 0; row < arm.mechanism().joints.size(); ++row) {
    const Mat6& inertia = arm.mechanism().joints[row].inertia;
    const double mass = inertia(0, 0);
    const Vec<double, 3> mass_centre{inertia(5, 1), inertia(3, 2), inertia(4, 0)};  // of [m c]x
    const Pose<double> T = arm.pose({"", static_cast<int>(row), {}});
    energy -= kGravity.dot(mass * T.t + T.R * mass_centre);
  }
  return energy;
}

TEST(RigidBodyDynamics, HasTheKineticEnergyOfItsMassMatrix) {
  Dice dice{1};
  for (const std::string_view urdf : {urdf::kHumanoidArm, urdf::kCabinet, urdf::kValve, urdf::kDoor}) {
    RigidBodyDynamics dynamics{read_mechanism(urdf), kGravity};
    const int nv = dynamics.mechanism().num_values();
    for (int i = 0; i < 20; ++i) {
      const JointVec q = random_values(dice, nv, 1.5), qdot = random_values(dice, nv, 2);
      dynamics.update(q, qdot);
      EXPECT_LT((dynamics.mass_matrix() - dynamics.mass_matrix().transpose()).norm(), 1e-12);
      const double energy = 0.5 * qdot.dot(dynamics.mass_matrix() * qdot);
      // A central difference over 1 us leaves 1e-9 of the rates by rounding.
      EXPECT_NEAR(energy, kinetic_energy(dynamics, q, qdot), 1e-7 * (1 + energy));
    }
  }
}

TEST(RigidBodyDynamics, ConservesEnergyWithoutFrictionAndForce) {
  RigidBodyDynamics arm{read_mechanism(urdf::kHumanoidArm), kGravity};
  JointVec q(7), qdot = JointVec::Zero(7);
  q << -0.4, -0.3, 0.2, -1.2, 0.3, 0.2, 0.1;
  const auto acceleration = [&arm](const JointVec& at, const JointVec& rate) {
    arm.update(at, rate);
    return JointVec{-arm.mass_matrix().ldlt().solve(arm.bias())};
  };
  arm.update(q, qdot);
  const double before = potential_energy(arm);
  constexpr double kStep_s = 5e-4;
  double swing = 0;
  for (int i = 0; i < 2000; ++i) {  // Runge and Kutta's fourth order: (5e-4)^4 times the rates' derivatives
    const JointVec a1 = acceleration(q, qdot);
    const JointVec v2 = qdot + 0.5 * kStep_s * a1, a2 = acceleration(q + 0.5 * kStep_s * qdot, v2);
    const JointVec v3 = qdot + 0.5 * kStep_s * a2, a3 = acceleration(q + 0.5 * kStep_s * v2, v3);
    const JointVec v4 = qdot + kStep_s * a3, a4 = acceleration(q + kStep_s * v3, v4);
    q += kStep_s / 6 * (qdot + 2 * v2 + 2 * v3 + v4);
    qdot += kStep_s / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    arm.update(q, qdot);
    const double kinetic = 0.5 * qdot.dot(arm.mass_matrix() * qdot);
    swing = std::max(swing, kinetic);
    ASSERT_NEAR(kinetic + potential_energy(arm), before, 1e-7) << "after " << i << " steps";
  }
  EXPECT_GT(swing, 1) << "J: it fell";
}

TEST(RigidBodyDynamics, JacobianAndDriftAreTheDerivativesOfThePose) {
  Dice dice{2};
  RigidBodyDynamics arm{read_mechanism(urdf::kHumanoidArm), kGravity};
  const MechanismLink& hand = arm.mechanism().link("hand");
  constexpr double kStep_s = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const JointVec q = random_values(dice, 7, 1), qdot = random_values(dice, 7, 1);
    arm.update(q + kStep_s * qdot, qdot);
    const Pose<double> after = arm.pose(hand);
    const Vec6 twist_after = arm.twist(hand);
    arm.update(q - kStep_s * qdot, qdot);
    const Pose<double> before = arm.pose(hand);
    const Vec6 twist_before = arm.twist(hand);
    arm.update(q, qdot);
    Vec6 moved;
    moved << after.t - before.t, math::log_so3<double>(after.R * before.R.conjugate());
    EXPECT_LT((arm.jacobian(hand) * qdot - moved / (2 * kStep_s)).norm(), 1e-8);  // differences over 1e-5 s
    EXPECT_LT((arm.twist(hand) - arm.jacobian(hand) * qdot).norm(), 1e-12);
    EXPECT_LT((arm.drift(hand) - (twist_after - twist_before) / (2 * kStep_s)).norm(), 1e-7);
  }
}

TEST(RigidBodyDynamics, CarriesTheStemOnTheWheelThatItMimics) {
  const Mechanism valve = read_mechanism(urdf::kValve);
  ASSERT_EQ(valve.num_values(), 1);
  RigidBodyDynamics dynamics{valve, kGravity};
  dynamics.update(JointVec::Constant(1, 2), JointVec::Zero(1));
  const double pitch = 0.0019098593171027;  // m/rad, of the file
  EXPECT_NEAR(dynamics.pose(valve.link("stem")).t.x(), 0.24 + 2 * pitch, 1e-15);
  EXPECT_NEAR(dynamics.mass_matrix()(0, 0), 0.009 + 0.4 * pitch * pitch, 1e-15);
}

}  // namespace
}  // namespace articam::sim
