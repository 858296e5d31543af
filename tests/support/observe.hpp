#pragma once
/// @file  Matches as a perfect or noisy detector would give them.

#include "core/tracker/articulation_matrix.hpp"
#include "tests/support/random_state.hpp"

namespace articam::test {

inline constexpr double kFocal_px = 525;

/// Every marker's feature at q on the metric plane, plus Gaussian noise; the variance says so (0.02 px when without).
template <class M, class S>
tracker::Matches<M, S> observe(const model::Configuration<M, S>& q, tracker::FeatureKind kind, double noise_px = 0,
                               Random* random = nullptr) {
  tracker::Matches<M, S> matches{};
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  const double variance_px2 = noise_px > 0 ? noise_px * noise_px : 0.02 * 0.02;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const double diameter_m = kind == tracker::FeatureKind::imaged_circle ? M::kMarkers[i].outer_diameter_m : 0;
    const auto s = vision::imaged_centre(tracker::circle_in_camera(q.T_cam_obj, kinematics.markers[i], diameter_m));
    if (!s.ok()) continue;
    Vec<S, 2> noise = Vec<S, 2>::Zero();
    if (random != nullptr) {
      noise = Vec<S, 2>{static_cast<S>(random->gaussian()), static_cast<S>(random->gaussian())} *
              static_cast<S>(noise_px / kFocal_px);
    }
    matches[i].matched = true;
    matches[i].s_star = s.value() + noise;
    matches[i].variance = static_cast<S>(variance_px2 / (kFocal_px * kFocal_px));
  }
  return matches;
}

/// The printer of the anchors: drawer 80 mm open, second marker at 120 mm, seen from 0.7 m.
template <class M, class S>
model::Configuration<M, S> nominal_printer() {
  constexpr double kDeg = 0.017453292519943295;
  model::Configuration<M, S> q;
  q.T_cam_obj.t = Vec<S, 3>{S(0.02), S(0.08), S(0.70)};
  const Quat<double> R = math::exp_so3<double>({0, 0, 5 * kDeg}) * math::exp_so3<double>({0, -10 * kDeg, 0}) *
                         math::exp_so3<double>({30 * kDeg, 0, 0});
  q.T_cam_obj.R = R.cast<S>();
  q.joints = Vec<S, 2>{S(0.08), S(0.12)};
  return q;
}

}  // namespace articam::test
