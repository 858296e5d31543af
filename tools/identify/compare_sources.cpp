#include "tools/identify/compare_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace articam::identify {
namespace {

bool same(const std::array<double, 3>& a, const Vec3& b) { return Vec3(a[0], a[1], a[2]) == b; }

bool same(const model::JointRow& a, const modelgen::TableJoint& b) {
  const auto& R = b.T_parent_joint.R;
  return a.name == b.name && a.kind == b.kind && a.parent == b.parent && same(a.axis, b.axis) &&
         same(a.t_parent_joint_m, b.T_parent_joint.t) &&
         a.r_parent_joint_wxyz == std::array{R.w(), R.x(), R.y(), R.z()} && a.leader == b.leader &&
         a.ratio == b.ratio && a.offset == b.offset;
}

bool same(const model::MarkerRow& a, const modelgen::TableMarker& b) {
  return a.name == b.name && a.kind == b.kind && a.body == b.body && same(a.t_body_m, b.t_body_m) &&
         same(a.normal, b.normal) && a.outer_diameter_m == b.outer_diameter_m;
}

/// The name of the first row that differs, or that only one of them has.
template <class Rows, class Others>
std::string first_difference(const Rows& rows, const Others& others) {
  for (std::size_t i = 0; i < std::max(rows.size(), others.size()); ++i) {
    if (i >= others.size()) return std::string{rows[i].name};
    if (i >= rows.size() || !same(rows[i], others[i])) return others[i].name;
  }
  return {};
}

}  // namespace

std::string why_different(const Object& object, const modelgen::Table& table) {
  const std::string joint = first_difference(object.joints(), table.joints);
  const std::string name = joint.empty() ? first_difference(object.markers(), table.markers) : joint;
  if (name.empty()) return {};
  return fmt::format(
      "{} '{}' is not as in the model that this program was compiled with; --urdf and --markers name its "
      "sources",
      joint.empty() ? "marker" : "joint", name);
}

std::vector<Mat3> axes_of_frames(modelgen::CompileJob job, const modelgen::MarkersFile& markers) {
  // A point on each axis of each frame: their places on the body say how it lies.
  for (const modelgen::Marker& marker : markers.markers) {
    for (int axis = -1; axis < 3; ++axis) {
      modelgen::Marker point;
      point.frame = marker.frame;
      point.name = fmt::format("axis {} of {}", axis, marker.frame);
      if (axis >= 0) point.offset_m[static_cast<std::size_t>(axis)] = 1;
      job.options.points.push_back(std::move(point));
    }
  }
  modelgen::Diagnostics heard_before;
  const auto compiled = modelgen::compile_model(job, heard_before);
  std::vector<Mat3> axes(markers.markers.size(), Mat3::Identity());
  for (std::size_t m = 0; compiled && m < axes.size(); ++m) {
    const auto point = compiled->table.markers.begin() + static_cast<std::ptrdiff_t>(axes.size() + 4 * m);
    for (int axis = 0; axis < 3; ++axis) axes[m].col(axis) = point[axis + 1].t_body_m - point[0].t_body_m;
  }
  return axes;
}

}  // namespace articam::identify
