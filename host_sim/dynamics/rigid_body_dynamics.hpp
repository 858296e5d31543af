#pragma once
/// @file  Where a mechanism's bodies are, how they move, and what force that takes.

#include <vector>

#include "host_sim/dynamics/mechanism.hpp"

namespace articam::sim {

/// M(q) qddot + h(q, qdot) = tau, of one mechanism at one state; {root} is at rest.
///
/// KDL (Debian: liborocos-kdl) computes the same and is the tests' oracle. It is not used here: it takes its sines from
/// the C library, whose last bits differ between machines, and every run must be the same on all of them; it knows no
/// mimic joints; and it took 3.5 times as long (6.3 us, an arm of seven joints).
///
/// Shapes  q, qdot, h nv; M nv x nv; Jacobians 6 x nv.
/// Frames  all in {root}. Twists are (velocity of the frame's origin, angular velocity).
/// Units   SI. Friction and damping are no part of h.
/// Source  Featherstone, "Rigid body dynamics algorithms", 2008: tables 5.1 (recursive Newton-Euler) and 6.2 (composite
///         rigid bodies), all written in {root}, so that nothing is carried from body to body.
class RigidBodyDynamics {
 public:
  explicit RigidBodyDynamics(const Mechanism& mechanism, const Vec<double, 3>& gravity);

  void update(const JointVec& q, const JointVec& qdot) noexcept;

  const Mechanism& mechanism() const noexcept { return mechanism_; }
  const JointMat& mass_matrix() const noexcept { return mass_matrix_; }
  const JointVec& bias() const noexcept { return bias_; }

  Pose<double> pose(const MechanismLink& link) const noexcept;
  /// Twist of {link} by unit rates.
  JointJacobian jacobian(const MechanismLink& link) const noexcept;
  /// Twist of {link}: jacobian qdot.
  Vec6 twist(const MechanismLink& link) const noexcept;
  /// Acceleration of {link} (of its origin's velocity, and angular) at qddot = 0: the jacobian's rate times qdot.
  Vec6 drift(const MechanismLink& link) const noexcept;

 private:
  /// Spatial quantities of a joint and the body below, about the origin of {root}.
  struct Body {
    Pose<double> T_root_body;
    Vec6 axis;  ///< twist by a unit rate of the joint
    Vec6 twist;
    Vec6 drift;      ///< spatial acceleration at qddot = 0, without gravity
    Mat6 composite;  ///< inertia of the body and all below it
    Vec6 force;      ///< what moves the body and all below it so
  };

  void move_body(std::size_t row, const JointVec& q, const JointVec& qdot) noexcept;
  void gather() noexcept;

  Mechanism mechanism_;
  Vec<double, 3> gravity_;
  std::vector<Body> bodies_;
  JointMat mass_matrix_;
  JointVec bias_;
};

}  // namespace articam::sim
