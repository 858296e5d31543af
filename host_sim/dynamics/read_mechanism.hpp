#pragma once
/// @file  URDF text -> the mechanism of its moving joints.

#include <map>
#include <string>
#include <string_view>

#include "host_sim/dynamics/mechanism.hpp"

namespace articam::sim {

/// Reads joints, limits, mimic, dynamics (damping, friction; `armature`, the motor's inertia, is our own attribute) and
/// inertials. A joint named in `held` stands at that value and moves no more; one that mimics a held joint stands, too.
/// Bodies without an inertial weigh nothing. A velocity or effort limit of 0 is none: the joint is passive.
/// Throws  std::invalid_argument with the reason: not well-formed, no single root, planar or floating joints, more than
///         kMaxJoints, a held joint or a leader that does not exist.
/// articam-modelgen judges a user's URDF; these are the simulation's own, read after that has accepted them.
Mechanism read_mechanism(std::string_view urdf, const std::map<std::string, double>& held = {});

}  // namespace articam::sim
