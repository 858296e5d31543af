#include "tools/report/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace articam::report {
namespace {

/// The pose of {obj} for a camera at `eye` that looks at `target`, its y down along the object's y where it can.
Pose<double> look_at(const Vec3& eye, const Vec3& target) {
  const Vec3 z = (target - eye).normalized();
  const Vec3 down = Vec3::UnitY() - z.y() * z;
  const Vec3 y = down.norm() > 0.1 ? Vec3(down.normalized()) : perpendicular(z);
  Eigen::Matrix3d R_cam_obj;
  R_cam_obj << y.cross(z).transpose(), y.transpose(), z.transpose();
  return {Quat<double>(R_cam_obj), -(R_cam_obj * eye)};
}

std::vector<VectorX> sample_joints(const modelgen::Table& table) {
  const auto n = static_cast<Eigen::Index>(table.values().size());
  if (n == 0) return {VectorX(0)};
  std::vector<VectorX> samples;
  for (const double share : {0.1, 0.5, 0.9}) samples.push_back(joints_at(table, share));
  // The numbers of any two joints differ in a bit: in the sample of that bit they part.
  for (Eigen::Index bit = 1; n > 1 && bit <= n; bit *= 2) {
    samples.push_back(
        joints_at(table, VectorX::NullaryExpr(n, [=](Eigen::Index j) { return ((j + 1) & bit) != 0 ? 0.9 : 0.1; })));
  }
  return samples;
}

}  // namespace

CameraParameters default_camera() {
  CameraParameters camera;
  camera.width_px = 640, camera.height_px = 480;
  camera.fx_px = camera.fy_px = 525;
  camera.cx_px = 319.5, camera.cy_px = 239.5;
  return camera;
}

double low_limit(const modelgen::TableJoint& joint) {
  if (joint.q_min > -model::kUnlimited) return joint.q_min;
  return joint.kind == model::JointKind::prismatic ? -0.5 : -std::numbers::pi;
}
double high_limit(const modelgen::TableJoint& joint) {
  if (joint.q_max < model::kUnlimited) return joint.q_max;
  return joint.kind == model::JointKind::prismatic ? 0.5 : std::numbers::pi;
}

VectorX joints_at(const modelgen::Table& table, const VectorX& shares) {
  const auto values = table.values();
  return VectorX::NullaryExpr(shares.size(), [&](Eigen::Index j) {
    const modelgen::TableJoint& joint = *values[static_cast<std::size_t>(j)];
    return low_limit(joint) + shares[j] * (high_limit(joint) - low_limit(joint));
  });
}

VectorX joints_at(const modelgen::Table& table, double share) {
  return joints_at(table, VectorX::Constant(static_cast<Eigen::Index>(table.values().size()), share));
}

Front front_of(const modelgen::Table& table, const Marks& marks) {
  Front front;
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t m = 0; m < table.markers.size(); ++m) {
    if (!is_mark(table.markers[m])) continue;
    front.middle += marks.centre[m];
    sum += marks.normal[m];
    ++count;
  }
  if (count > 0) front.middle /= count;
  if (sum.norm() > 0.1) front.normal = sum.normalized();
  return front;
}

std::vector<View> sample_views(const modelgen::Table& table, const Conditions& conditions) {
  const std::vector<double> ranges{conditions.min_range_m, std::sqrt(conditions.min_range_m * conditions.max_range_m),
                                   conditions.max_range_m};
  std::vector<View> views;
  for (const VectorX& joints : sample_joints(table)) {
    const Front front = front_of(table, place_marks(table, joints));
    const Vec3 right = perpendicular(front.normal), up = front.normal.cross(right);
    for (const double range : ranges) {
      for (double tilt = 0; tilt <= conditions.max_tilt_deg; tilt += 20) {
        for (double azimuth = 0; azimuth < (tilt == 0 ? 1 : 360); azimuth += 45) {
          const Vec3 side = std::cos(azimuth * kDegree) * right + std::sin(azimuth * kDegree) * up;
          const Vec3 from = std::cos(tilt * kDegree) * front.normal + std::sin(tilt * kDegree) * side;
          views.push_back({look_at(front.middle + range * from, front.middle), joints, range, tilt, from});
        }
      }
    }
  }
  return views;
}

std::string describe_joints(const VectorX& joints, const modelgen::Table& table, std::size_t first_joint) {
  constexpr std::size_t kMost = 3;
  const auto values = table.values();
  std::string text;
  for (std::size_t i = 0; i < std::min(values.size(), kMost); ++i) {
    const std::size_t j = (first_joint + i) % values.size();
    text += fmt::format("{}{} {:.3g}", i == 0 ? "" : ", ", values[j]->name, joints[static_cast<Eigen::Index>(j)]);
  }
  return values.size() > kMost ? fmt::format("{} and {} more", text, values.size() - kMost) : text;
}

std::string describe(const View& view, const modelgen::Table& table, std::size_t first_joint) {
  const Vec3 from = view.from.unaryExpr([](double x) { return std::round(100 * x) / 100 + 0.0; });  // no -0.00
  const std::string joints = describe_joints(view.joints, table, first_joint);
  return fmt::format("range {:.2f} m, tilt {:.0f} deg from ({:.2f} {:.2f} {:.2f}){}{}", view.range_m, view.tilt_deg,
                     from.x(), from.y(), from.z(), joints.empty() ? "" : ", ", joints);
}

}  // namespace articam::report
