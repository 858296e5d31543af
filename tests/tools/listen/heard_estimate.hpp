#pragma once
/// @file  An estimate as the outputs get it, made up.

#include "core/math/se3.hpp"
#include "tests/support/wire_messages.hpp"
#include "tools/listen/output.hpp"

namespace articam::test {

/// A valid estimate of two joints with a covariance that is one, and the pose in {base} for a known camera.
struct MadeUp {
  explicit MadeUp(Random& random) : estimate{random_estimate(random)}, model{random_model(random)} {
    Mat<double, 8, 8> root;
    for (int i = 0; i < 64; ++i) root(i / 8, i % 8) = random.uniform(-1e-3, 1e-3);
    covariance = root * root.transpose();
    estimate.covariance.clear();
    for (int i = 0; i < 8; ++i) {
      for (int k = i; k < 8; ++k) (void)estimate.covariance.push_back(covariance(i, k));
    }
    T_base_cam = {math::exp_so3<double>({0.3, -1.1, 0.4}), {0.5, 0.1, -0.2}};
    const auto& T = estimate.t_cam_obj;
    const Pose<double> T_base_obj = T_base_cam * Pose<double>{{T[3], T[4], T[5], T[6]}, {T[0], T[1], T[2]}};
    estimate.t_base_obj.clear();
    for (const double x : {T_base_obj.t.x(), T_base_obj.t.y(), T_base_obj.t.z(), T_base_obj.R.w(), T_base_obj.R.x(),
                           T_base_obj.R.y(), T_base_obj.R.z()}) {
      (void)estimate.t_base_obj.push_back(x);
    }
    estimate.matched = 6;
  }
  /// As heard from this machine.
  listen::Heard heard() const {
    return {estimate,
            model,
            {estimate.t_capture.ns - 1'500'000'000},
            {1'700'000'000'040'000'000, 1'700'000'000'030'000'000, 1'700'000'000'010'000'000, 0.03, true}};
  }

  wire::EstimateMessage estimate;
  wire::ModelMessage model;
  Mat<double, 8, 8> covariance;
  Pose<double> T_base_cam;
};

/// The same without numbers.
inline void make_invalid(wire::EstimateMessage& m) {
  m.valid = false, m.status = tracker::TrackingStatus::lost, m.reason = tracker::Reason::few_markers;
  m.t_cam_obj.clear(), m.joints.clear(), m.velocity.clear(), m.covariance.clear(), m.t_base_obj.clear();
  m.matched = 0, m.rms_px = 0;
}

}  // namespace articam::test
