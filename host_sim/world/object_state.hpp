#pragma once
/// @file  The true object at one instant, and what of it a camera can see.

#include <vector>

#include "core/model/configuration.hpp"
#include "core/model/forward_kinematics.hpp"
#include "core/model/point_jacobian.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// Pose of {obj} in {cam}; qdot of size 6 + n, ordered (t, rotation, joints) in {cam}, as the tracker's.
template <class Model>
struct ObjectState {
  model::Configuration<Model, double> q{};
  Vec<double, model::kDof<Model>> qdot{Vec<double, model::kDof<Model>>::Zero()};
};

/// The marks of a model, in the table's order.
template <class Model>
std::vector<SceneMarker> scene_markers(const ObjectState<Model>& object) {
  const Pose<double>& T_cam_obj = object.q.T_cam_obj;
  const auto kinematics = model::forward_kinematics<Model, double>(object.q.joints);
  std::vector<SceneMarker> markers;
  markers.reserve(Model::kMarkers.size());
  for (std::size_t i = 0; i < Model::kMarkers.size(); ++i) {
    const model::MarkerRow& row = Model::kMarkers[i];
    const Vec<double, 6> twist =  // at the origin of {cam}
        model::point_jacobian<Model, double>(kinematics, T_cam_obj, row.body).lazyProduct(object.qdot);
    const Vec<double, 3> centre = T_cam_obj * kinematics.markers[i].centre, angular = twist.template tail<3>();
    markers.push_back({row.kind, centre, T_cam_obj.R * kinematics.markers[i].normal, 0.5 * row.outer_diameter_m,
                       0.5 * row.inner_diameter_m, twist.template head<3>() + angular.cross(centre), angular});
  }
  return markers;
}

/// The same of a model that rests at a configuration.
template <class Model>
std::vector<SceneMarker> scene_markers(const model::Configuration<Model, double>& q) {
  return scene_markers<Model>(ObjectState<Model>{q});
}

}  // namespace articam::sim
