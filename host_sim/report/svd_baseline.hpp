#pragma once
/// @file  What the paper compares with: the configuration from 3-D marker positions alone.

#include <optional>
#include <vector>

#include "core/math/rigid_registration.hpp"
#include "core/model/forward_kinematics.hpp"
#include "core/tracker/associate.hpp"
#include "core/vision/circle_poses.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// The base by equation (7) from the base's marks. Each prismatic joint on its own, from its first mark seen: a joint
/// below the base along its axis in F_o (the drawer: -z); a joint below another as the distance in {cam} of the two
/// marks, beyond their distance in the table.
/// Nothing where fewer than 3 marks of the base, or none of a joint, were seen, or where a joint turns or mimics.
template <class Model, class S>
std::optional<PlainConfiguration> svd_baseline(const tracker::Matches<Model, S>& matches,
                                               const vision::Detections& detections,
                                               const vision::CameraModel<S>& camera) {
  const auto at_zero = model::forward_kinematics<Model, double>(Vec<double, model::kNumJoints<Model>>::Zero());
  std::vector<Vec<double, 3>> base_cam, base_obj;
  struct Mark {
    Vec<double, 3> p_cam, p_obj_at_zero;
  };
  std::array<std::optional<Mark>, static_cast<std::size_t>(model::kNumBodies<Model>)> first_mark;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].matched) continue;
    const model::MarkerRow& row = Model::kMarkers[i];
    const auto& image = detections[static_cast<std::size_t>(matches[i].detection)].outer;
    const auto poses = vision::circle_poses(image, static_cast<S>(0.5 * row.outer_diameter_m), camera);
    if (!poses.ok()) continue;
    const Mark mark{poses.value().mean_centre().template cast<double>(), at_zero.markers[i].centre};
    if (row.body < 0) {
      base_cam.push_back(mark.p_cam);
      base_obj.push_back(mark.p_obj_at_zero);
    } else if (auto& first = first_mark[static_cast<std::size_t>(row.body)]; !first) {
      first = mark;
    }
  }
  const auto T_cam_obj = math::rigid_registration<double>(base_cam, base_obj);
  if (!T_cam_obj.ok()) return std::nullopt;

  PlainConfiguration found{T_cam_obj.value(), {}};
  for (std::size_t j = 0; j < first_mark.size(); ++j) {
    const model::JointRow& joint = Model::kJoints[j];
    if (joint.kind != model::JointKind::prismatic || joint.leader >= 0 || !first_mark[j]) return std::nullopt;
    const Mark& mark = *first_mark[j];
    if (joint.parent < 0) {
      const Vec<double, 3> way = T_cam_obj.value().inverse() * mark.p_cam - mark.p_obj_at_zero;
      found.joints.push_back(way.dot(at_zero.joint_twist[j].linear));
    } else {
      const auto& other = first_mark[static_cast<std::size_t>(joint.parent)];
      if (!other) return std::nullopt;
      found.joints.push_back((mark.p_cam - other->p_cam).norm() - (mark.p_obj_at_zero - other->p_obj_at_zero).norm());
    }
  }
  return found;
}

}  // namespace articam::sim
