#include "tools/picture/scene.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include "core/math/so3.hpp"
#include "core/math/trigonometry.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/reduce.hpp"
#include "tools/picture/read_visuals.hpp"

namespace articam::picture {
namespace {

using Poses = std::map<std::string, Pose<double>>;

/// Where a joint stands that no value is known of.
double nearest_to_0(const modelgen::UrdfJoint& joint) { return std::clamp(0.0, joint.lower, joint.upper); }

/// Poses of all links below one, the joints at these values; every joint that moves has one, or is held.
void place_below(const std::string& link, const Pose<double>& T_cam_link, const modelgen::UrdfModel& model,
                 const std::map<std::string, double>& values, Poses& poses) {
  poses[link] = T_cam_link;
  for (const modelgen::UrdfJoint& joint : model.joints) {
    if (joint.parent != link) continue;
    Pose<double> T_parent_child = modelgen::pose_of(joint.origin_xyz, joint.origin_rpy);
    if (joint.moves()) {
      const double own = joint.mimics ? joint.ratio * values.at(joint.leader) + joint.offset : values.at(joint.name);
      const Vec3 step = Vec3(joint.axis[0], joint.axis[1], joint.axis[2]).normalized() * joint.held.value_or(own);
      T_parent_child = T_parent_child * modelgen::displacement(joint.type == modelgen::JointType::prismatic, step);
    }
    place_below(joint.child, T_cam_link * T_parent_child, model, values, poses);
  }
}

Poses poses_at_start(const modelgen::UrdfModel& model, const modelgen::Table& table) {
  const auto& q0 = table.q0;
  std::map<std::string, double> values;
  for (const modelgen::UrdfJoint& joint : model.joints) values[joint.name] = nearest_to_0(joint);
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

/// Names of the marks of which not every point does: of the edge, a little inside, and the centre; in {cam}.
template <class Does>
std::vector<std::string> marks_that_fail(const Scene& scene, const Does& does) {
  constexpr int kAround = 16;
  std::vector<std::string> failing;
  for (const Shape& mark : scene.shapes) {
    if (mark.marker < 0) continue;
    bool all = true;
    for (int i = 0; i <= kAround; ++i) {
      const auto turn = math::sin_cos(2 * std::numbers::pi / kAround * i);
      const double r = i == kAround ? 0 : 0.49 * mark.size[1];
      all = all && does(mark, mark.T_cam_shape * Vec3(r * turn.cos, r * turn.sin, 0));
    }
    if (!all) failing.push_back(scene.markers[static_cast<std::size_t>(mark.marker)]);
  }
  return failing;
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
  return marks_that_fail(scene, [&](const Shape& mark, const Vec3& p_cam) {
    const auto sight = first_met({Vec3::Zero(), p_cam}, scene.shapes);
    return sight && sight->shape == &mark;
  });
}

std::vector<std::string> cut_markers(const Scene& scene, const CameraParameters& camera) {
  return marks_that_fail(scene, [&](const Shape&, const Vec3& p_cam) {
    if (!(p_cam.z() > 0)) return false;
    const double u_px = camera.fx_px * p_cam.x() / p_cam.z() + camera.cx_px;
    const double v_px = camera.fy_px * p_cam.y() / p_cam.z() + camera.cy_px;
    return u_px >= 0 && v_px >= 0 && u_px <= camera.width_px - 1 && v_px <= camera.height_px - 1;
  });
}

}  // namespace articam::picture
