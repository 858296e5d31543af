#include "tools/picture/scene.hpp"

#include <map>

#include "core/math/so3.hpp"
#include "core/math/trigonometry.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/reduce.hpp"
#include "tools/picture/read_visuals.hpp"

namespace articam::picture {
namespace {

using Poses = std::map<std::string, Pose<double>>;

/// Poses of all links below one, the joints at these values; joints without one stand at 0.
void place_below(const std::string& link, const Pose<double>& T_cam_link, const modelgen::UrdfModel& model,
                 const std::map<std::string, double>& values, Poses& poses) {
  poses[link] = T_cam_link;
  const auto value_of = [&](const std::string& name) { return values.contains(name) ? values.at(name) : 0.0; };
  for (const modelgen::UrdfJoint& joint : model.joints) {
    if (joint.parent != link) continue;
    const double own = joint.mimics ? joint.ratio * value_of(joint.leader) + joint.offset : value_of(joint.name);
    const Vec3 step = Vec3(joint.axis[0], joint.axis[1], joint.axis[2]).normalized() * joint.held.value_or(own);
    Pose<double> T_parent_child = modelgen::pose_of(joint.origin_xyz, joint.origin_rpy);
    if (joint.moves()) {
      T_parent_child = T_parent_child * modelgen::displacement(joint.type == modelgen::JointType::prismatic, step);
    }
    place_below(joint.child, T_cam_link * T_parent_child, model, values, poses);
  }
}

Poses poses_at_start(const modelgen::UrdfModel& model, const modelgen::Table& table) {
  const auto& q0 = table.q0;
  std::map<std::string, double> values;
  std::size_t next = 7;
  for (const modelgen::TableJoint* joint : table.values()) values[joint->name] = q0[next++];
  const Pose<double> T_cam_obj{Quat<double>(q0[3], q0[4], q0[5], q0[6]).normalized(), {q0[0], q0[1], q0[2]}};
  Poses poses;
  place_below(table.root_link, T_cam_obj, model, values, poses);
  return poses;
}

Shape mark_of(const modelgen::TableMarker& marker, const Pose<double>& T_cam_link, int index) {
  constexpr double kCardRatio = 1.4;
  constexpr double kAbove_m = 3e-4;  // a card is glued onto a face: above it for the rays
  constexpr Colour kLight{0.97, 0.97, 0.97}, kDark{0.1, 0.1, 0.1};
  const bool light = marker.kind == model::MarkerKind::dot_light_on_dark;
  return {Form::mark,
          T_cam_link * Pose<double>{Quat<double>::Identity(), {0, 0, kAbove_m}},
          {kCardRatio * marker.outer_diameter_m, marker.outer_diameter_m, marker.inner_diameter_m},
          light ? kDark : kLight,
          light ? kLight : kDark,
          index};
}

}  // namespace

std::optional<Scene> scene_of(const modelgen::SourceFile& urdf, const modelgen::SourceFile& markers_source,
                              modelgen::Diagnostics& diagnostics) {
  const auto compiled = modelgen::compile_model({urdf, markers_source, "Scene", {}}, diagnostics);
  if (!compiled) return std::nullopt;
  if (compiled->table.q0.empty()) {
    diagnostics.error(markers_source.path, 0, "q0", "is missing: nothing says where the camera stands");
    return std::nullopt;
  }
  const Poses poses = poses_at_start(compiled->model, compiled->table);
  Scene scene;
  for (const Visual& visual : read_visuals(urdf, diagnostics)) {
    scene.shapes.push_back(
        {visual.form, poses.at(visual.link) * visual.T_link_shape, visual.size, visual.colour, {}, -1});
  }
  for (const modelgen::TableMarker& marker : compiled->table.markers) {
    const int index = static_cast<int>(scene.markers.size());
    scene.shapes.push_back(mark_of(marker, poses.at(marker.name), index));
    scene.markers.push_back(marker.name);
  }
  return diagnostics.has_errors() ? std::nullopt : std::optional{scene};
}

std::optional<Sight> first_met(const Ray& ray, const std::vector<Shape>& shapes) {
  std::optional<Sight> first;
  for (const Shape& shape : shapes) {
    const auto hit = meet(ray, shape);
    if (hit && (!first || hit->t < first->hit.t)) first = Sight{&shape, *hit};
  }
  return first;
}

std::vector<std::string> hidden_markers(const Scene& scene) {
  constexpr int kAround = 16;
  std::vector<std::string> hidden;
  for (const Shape& mark : scene.shapes) {
    if (mark.marker < 0) continue;
    bool whole = true;
    for (int i = 0; i <= kAround; ++i) {  // its edge, a little inside, and its centre
      const auto turn = math::sin_cos(2 * 3.14159265358979323846 / kAround * i);
      const double r = i == kAround ? 0 : 0.49 * mark.size[1];
      const auto sight =
          first_met({Vec3::Zero(), mark.T_cam_shape * Vec3(r * turn.cos, r * turn.sin, 0)}, scene.shapes);
      whole = whole && sight && sight->shape == &mark;
    }
    if (!whole) hidden.push_back(scene.markers[static_cast<std::size_t>(mark.marker)]);
  }
  return hidden;
}

}  // namespace articam::picture
