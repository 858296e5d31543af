#pragma once
/// @file  The true object at one instant, and what of it a camera can see.

#include <vector>

#include "core/model/configuration.hpp"
#include "core/model/forward_kinematics.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// Pose of {obj} in {cam}; qdot of size 6 + n, ordered (t, rotation, joints) in {cam}, as the tracker's.
template <class Model>
struct ObjectState {
  model::Configuration<Model, double> q{};
  Vec<double, model::kDof<Model>> qdot{Vec<double, model::kDof<Model>>::Zero()};
};

/// The marks of a model at a configuration, in the table's order.
template <class Model>
std::vector<SceneMarker> scene_markers(const model::Configuration<Model, double>& q) {
  const auto kinematics = model::forward_kinematics<Model, double>(q.joints);
  std::vector<SceneMarker> markers;
  for (std::size_t i = 0; i < Model::kMarkers.size(); ++i) {
    const model::MarkerRow& row = Model::kMarkers[i];
    markers.push_back({row.kind, q.T_cam_obj * kinematics.markers[i].centre,
                       q.T_cam_obj.R * kinematics.markers[i].normal, 0.5 * row.outer_diameter_m,
                       0.5 * row.inner_diameter_m});
  }
  return markers;
}

}  // namespace articam::sim
