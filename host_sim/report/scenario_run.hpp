#pragma once
/// @file  What the report needs to know of a scenario.

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/report/camera_picture.hpp"
#include "host_sim/report/run_record.hpp"
#include "host_sim/scenarios/scenario.hpp"
#include "host_sim/world/object_state.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// A run before its first frame.
template <class Model>
RunRecord describe(const Scenario<Model>& scenario, const std::string& mode, const RenderOptions& rendering) {
  RunRecord run;
  run.scenario = scenario.name;
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

template <class Model>
std::vector<SceneMarker> scene_markers(const PlainConfiguration& plain) {
  model::Configuration<Model, double> q;
  q.T_cam_obj = plain.T_cam_obj;
  for (int j = 0; j < model::kNumJoints<Model>; ++j) q.joints[j] = plain.joints[static_cast<std::size_t>(j)];
  return scene_markers<Model>(q);
}

/// A frame as the camera saw it, with what was estimated there, as an SVG.
template <class Model>
std::string picture_of(const FrameRecord& frame, Renderer& renderer) {
  std::vector<std::uint8_t> pixels;
  renderer.render(scene_markers<Model>(frame.truth), frame.frame, pixels);
  std::vector<SceneMarker> outlined;
  if (frame.estimate) outlined = scene_markers<Model>(*frame.estimate);
  const CameraParameters& camera = renderer.camera();
  return camera_picture({pixels.data(), camera.width_px, camera.height_px, camera.width_px}, camera, outlined);
}

}  // namespace articam::sim
