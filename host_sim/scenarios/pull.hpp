#pragma once
/// @file  A scenario in which a robot moves the object's joint, as data.

#include <array>
#include <string_view>
#include <vector>

#include "host_sim/loop/manipulation.hpp"

namespace articam::sim {

enum class FaultKind {
  dropped,    ///< the frame is lost; `amount`: the share that is
  late,       ///< the frame arrives `amount` seconds later than others
  repeated,   ///< the frame comes a second time
  stamped,    ///< the frame's time is `amount` seconds more than the truth
  cut,        ///< the buffer lacks half of its rows, or a byte of each
  silent,     ///< the camera gives nothing
  unplugged,  ///< and says that it is gone
  hidden,     ///< only the first `amount` markers are seen
  planted,    ///< `amount` rings that belong to nobody drift by
  moved,      ///< the first marker is `amount` metres from where it belongs
  warped,     ///< every marker is, each in another direction
  exposure,   ///< light by `amount` of what is right
  flicker,    ///< light swings from 0.5 to 1.3 of what is right and back, `amount` times a second
  blur,       ///< sigma of the lens becomes `amount` px
  friction,   ///< of the object, becomes `amount` times the model's
};

/// Something that goes wrong in [from_s, to_s).
struct Fault {
  FaultKind kind{};
  double from_s{}, to_s{};
  double amount{};

  constexpr bool at(double t_s) const noexcept { return t_s >= from_s && t_s < to_s; }
};

/// A robot, where it holds the object, and what it is told to do with it.
struct Pull {
  std::string_view object_urdf;
  int joint{};                   ///< index of the joint in the model's q; the others are held
  std::string_view handle_link;  ///< of the object
  Vec<double, 3> handle_m;       ///< where the hand takes hold, in that link
  Mat<double, 3, 3> R_obj_base;  ///< how the robot stands: columns forwards, left, up
  std::array<double, 7> posture{-0.35, -0.25, 0.1, -1.3, 0.1, 0.1, 0.1};  ///< of humanoid_arm
  std::vector<JointCommand> commands;                                     ///< the first one switches control on
  double settled{};  ///< so near the target for good is settled, m or rad
  WorldOptions world;
  ControlOptions control;
};

}  // namespace articam::sim
