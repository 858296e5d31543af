#include "host_sim/dynamics/rigid_body_dynamics.hpp"

#include <gtest/gtest.h>

#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/tree.hpp>
#include <kdl_parser/kdl_parser.hpp>

#include "host_sim/dynamics/read_mechanism.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"
#include "host_sim/world/hash.hpp"

namespace articam::sim {
namespace {

/// Another parser and another library: urdfdom and KDL.
TEST(RigidBodyDynamics, AgreesWithKdlOnTheArm) {
  KDL::Tree tree;
  ASSERT_TRUE(kdl_parser::treeFromString(std::string{urdf::kHumanoidArm}, tree));
  KDL::Chain chain;
  ASSERT_TRUE(tree.getChain("chest", "hand", chain));
  const KDL::Vector gravity{0.3, -0.2, -9.7};
  KDL::ChainDynParam kdl{chain, gravity};
  KDL::ChainFkSolverPos_recursive forward{chain};
  RigidBodyDynamics ours{read_mechanism(urdf::kHumanoidArm), {gravity.x(), gravity.y(), gravity.z()}};

  Dice dice{3};
  constexpr int kNv = 7;
  for (int i = 0; i < 50; ++i) {
    KDL::JntArray q{kNv}, qdot{kNv}, coriolis{kNv}, weight{kNv};
    for (unsigned j = 0; j < kNv; ++j) q(j) = dice.between(-1.5, 1.5), qdot(j) = dice.between(-2, 2);
    KDL::JntSpaceInertiaMatrix M{kNv};
    KDL::Frame hand;
    ASSERT_GE(kdl.JntToMass(q, M), 0);
    ASSERT_GE(kdl.JntToCoriolis(q, qdot, coriolis), 0);
    ASSERT_GE(kdl.JntToGravity(q, weight), 0);
    ASSERT_GE(forward.JntToCart(q, hand), 0);

    ours.update(q.data, qdot.data);
    JointMat without_rotors = ours.mass_matrix();  // KDL's reader knows no `armature`
    for (int j = 0; j < kNv; ++j) without_rotors(j, j) -= ours.mechanism().of_value(j).rotor_inertia;
    // Rounding: numbers up to 20, some hundred operations.
    EXPECT_LT((without_rotors - M.data).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((ours.bias() - coriolis.data - weight.data).cwiseAbs().maxCoeff(), 1e-11);
    const Vec<double, 3> t = ours.pose(ours.mechanism().link("hand")).t;
    EXPECT_LT((t - Vec<double, 3>{hand.p.x(), hand.p.y(), hand.p.z()}).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace articam::sim
