#pragma once
/// @file  A robot opens and closes one of two drawers.

#include "core/model/configuration.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"
#include "host_sim/scenarios/scenario.hpp"
#include "static_models/cabinet/cabinet.hpp"
#include "static_models/cameras/xtion_vga.hpp"

namespace articam::sim {

inline Scenario<models::Cabinet> cabinet_scenario() {
  Scenario<models::Cabinet> cabinet{.name = "cabinet",
                                    .summary = "a robot moves the upper of two drawers, beside a door that stands open",
                                    .duration_s = 30,
                                    .rest_s = 3,
                                    .camera = cameras::kXtionVga};
  cabinet.rest.q = model::from_numbers<models::Cabinet, double>(models::Cabinet::kQ0).value();
  Pull& pull = cabinet.pull.emplace();
  pull.object_urdf = urdf::kCabinet;
  pull.joint = models::Cabinet::Joint::kUpperSlide;
  pull.handle_link = "upper_drawer";
  pull.handle_m = {0.03, 0.05, 0.15};
  pull.R_obj_base << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  pull.commands = {{3, 0.2}, {5, 0.28}, {12, 0.18}, {18, 0.26}, {24, 0.2}};
  pull.settled = 0.003;
  return cabinet;
}

}  // namespace articam::sim
