#pragma once
/// @file  Matches and a configuration -> the equations of one step: error e and articulation matrix A.

#include "core/model/point_jacobian.hpp"
#include "core/tracker/associate.hpp"
#include "core/vision/imaged_circle.hpp"
#include "core/vision/interaction_matrix.hpp"

namespace articam::tracker {

/// e = s - s_star and A with  edot = A qdot - s_star_dot (paper eq. 3, 4). Marker i has rows 2i and 2i + 1; they are
/// zero where it has no match. The paper's law needs A itself; what has the normal equations only is in
/// normal_equations.hpp, which never builds it.
///
/// Shapes  e 2p, A 2p x nv.  Units  metric image plane.
template <class M, class S>
struct System {
  static constexpr int kRows = 2 * model::kNumMarkers<M>;
  static constexpr int kDof = model::kDof<M>;
  Vec<S, kRows> e = math::zeros<Vec<S, kRows>>();
  Mat<S, kRows, kDof> A = math::zeros<Mat<S, kRows, kDof>>();
};

/// Errors  behind_camera when a matched marker is not in front of the camera; `system` is then not to be used.
template <class M, class S>
Status stack(const Matches<M, S>& matches, const model::Configuration<M, S>& q, FeatureKind kind,
             System<M, S>& system) noexcept {
  system = {};
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].matched) continue;
    const model::MarkerRow& row = M::kMarkers[i];
    const double diameter_m = kind == FeatureKind::imaged_circle ? row.outer_diameter_m : 0.0;
    const auto circle = circle_in_camera(q.T_cam_obj, kinematics.markers[i], diameter_m);
    const auto s = vision::imaged_centre(circle);
    if (!s.ok()) return s.status();
    const auto L = kind == FeatureKind::imaged_circle ? vision::imaged_centre_interaction_matrix(circle)
                                                      : vision::interaction_matrix<S>(s.value(), circle.centre.z());
    if (!L.ok()) return L.status();
    const auto J = model::point_jacobian<M, S>(kinematics, q.T_cam_obj, row.body);
    const auto i_row = static_cast<Eigen::Index>(2 * i);
    for (Eigen::Index r = 0; r < 2; ++r) {
      system.e[i_row + r] = s.value()[r] - matches[i].s_star[r];
      for (Eigen::Index c = 0; c < model::kDof<M>; ++c) {
        S sum{0};
        for (Eigen::Index k = 0; k < 6; ++k) sum -= L.value()(r, k) * J(k, c);  // A_i = -L_i J_i
        system.A(i_row + r, c) = sum;
      }
    }
  }
  return Status::ok;
}

}  // namespace articam::tracker
