#pragma once
/// @file  A robot opens and closes a door.

#include "core/model/configuration.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"
#include "host_sim/scenarios/scenario.hpp"
#include "static_models/cameras/xtion_vga.hpp"
#include "static_models/door/door.hpp"

namespace articam::sim {

inline Scenario<models::Door> door_scenario() {
  Scenario<models::Door> door{.name = "door",
                              .summary = "a robot swings a door, its hand below the lever",
                              .duration_s = 30,
                              .rest_s = 3,
                              .camera = cameras::kXtionVga};
  door.rest.q = model::from_numbers<models::Door, double>(models::Door::kQ0).value();
  Pull& pull = door.pull.emplace();
  pull.object_urdf = urdf::kDoor;
  pull.joint = models::Door::Joint::kHinge;
  pull.handle_link = "leaf";
  pull.handle_m = {0.06, 0.62, -0.05};  // on the lever it would hide its ring
  pull.R_obj_base << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  pull.control.max_object_rate = 0.12;  // rad/s
  pull.commands = {{3, 0.4}, {5, 0.6}, {12, 0.45}, {18, 0.65}, {24, 0.4}};
  pull.settled = 0.006;
  return door;
}

}  // namespace articam::sim
