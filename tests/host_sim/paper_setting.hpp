#pragma once
/// @file  The robot at the printer, for tests.

#include "host_sim/dynamics/read_mechanism.hpp"
#include "host_sim/scenarios/paper.hpp"

namespace articam::sim::test {

inline Setting paper_setting() {
  const Pull pull = pull_of_the_drawer();
  const auto rest = PaperScenario::at(0);
  return make_setting(
      read_mechanism(urdf::kHumanoidArm), read_mechanism(pull.object_urdf, {{"marker_distance", rest.q.joints[1]}}),
      std::string{pull.handle_link}, pull.handle_m, rest.q.joints[0],
      Eigen::Map<const Vec<double, 7>>{pull.posture.data()}, Quat<double>{pull.R_obj_base}, rest.q.T_cam_obj);
}

}  // namespace articam::sim::test
