#pragma once
/// @file  What the report needs to know of a scenario.

#include <string>

#include "host_sim/report/run_record.hpp"
#include "host_sim/scenarios/scenario.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// A run before its first frame.
template <class Model>
RunRecord describe(const Scenario<Model>& scenario, const std::string& mode, const RenderOptions& rendering) {
  RunRecord run;
  run.scenario = scenario.name;
  run.summary = scenario.summary;
  run.mode = mode;
  run.seed = rendering.seed;
  run.noise_grey = rendering.noise_grey;
  run.blur_px = rendering.blur_px;
  run.rest_s = scenario.rest_s;
  run.degrees_of_freedom = model::kDof<Model>;
  if (scenario.pull) run.pulled_joint = scenario.pull->joint;
  for (const model::JointRow& joint : model::kValueRows<Model>) {
    run.joint_names.emplace_back(joint.name);
    run.joint_is_length.push_back(joint.kind == model::JointKind::prismatic);
  }
  return run;
}

}  // namespace articam::sim
