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

/// The marks of a model that rests at a configuration, in the table's order.
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

/// The same while it moves.
template <class Model>
std::vector<SceneMarker> scene_markers(const ObjectState<Model>& object) {
  std::vector<SceneMarker> markers = scene_markers<Model>(object.q);
  const auto kinematics = model::forward_kinematics<Model, double>(object.q.joints);
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const auto J = model::point_jacobian<Model, double>(kinematics, object.q.T_cam_obj, Model::kMarkers[i].body);
    const Vec<double, 6> twist = J * object.qdot;  // at the origin of {cam}
    markers[i].angular_velocity = twist.template tail<3>();
    markers[i].velocity = twist.template head<3>() + markers[i].angular_velocity.cross(markers[i].centre_cam_m);
  }
  return markers;
}

}  // namespace articam::sim
