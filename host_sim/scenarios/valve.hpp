#pragma once
/// @file  A robot turns the handwheel of a valve.

#include "core/model/configuration.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"
#include "host_sim/scenarios/scenario.hpp"
#include "static_models/cameras/xtion_vga.hpp"
#include "static_models/valve/valve.hpp"

namespace articam::sim {

inline Scenario<models::Valve> valve_scenario() {
  Scenario<models::Valve> valve{.name = "valve",
                                .summary = "a robot turns a handwheel to and fro; a stem counts the turns",
                                .duration_s = 30,
                                .rest_s = 3,
                                .camera = cameras::kXtionVga};
  valve.rest.q = model::from_numbers<models::Valve, double>(models::Valve::kQ0).value();
  Pull& pull = valve.pull.emplace();
  pull.object_urdf = urdf::kValve;
  pull.joint = models::Valve::Joint::kWheelTurn;
  pull.handle_link = "wheel";
  pull.handle_m = {0.02, -0.07, 0.07};
  pull.R_obj_base << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  pull.control.max_object_rate = 0.4;  // rad/s
  pull.commands = {{3, 0.5}, {5, 0.9}, {12, 0.3}, {18, 0.7}, {24, 0.5}};
  pull.settled = 0.04;
  return valve;
}

}  // namespace articam::sim
