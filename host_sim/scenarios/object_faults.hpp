#pragma once
/// @file  Objects that are not what the model says, or hard to see as it says, and what must then be said.

#include "host_sim/scenarios/faulty_paper.hpp"

namespace articam::sim {

/// A printer that stands `far_m` before the camera and turns about its vertical.
inline ObjectState<models::PrinterDrawer> turned_printer(double far_m, double turn_rad, double drawer_m) {
  ObjectState<models::PrinterDrawer> object;
  object.q.T_cam_obj.t = {0, 0.04, far_m};
  object.q.T_cam_obj.R = math::exp_so3<double>({0, turn_rad, 0});
  object.q.joints = {drawer_m, 0.12};
  return object;
}

/// Its drawer is closed, so that six rings lie in a plane, each of 9 px; it turns to and fro through facing the camera.
/// The mirror image of what is seen is as far turned the other way.
inline constexpr double kFlatTurn_rad = 0.06;
inline FaultyPaper far_and_flat_scenario() {
  using enum tracker::TrackingStatus;
  using enum tracker::Reason;
  const auto motion = [](double t_s) {
    constexpr double kRate = 0.6;  // rad/s
    const auto phase = math::sin_cos(kRate * t_s);
    ObjectState<models::PrinterDrawer> object = turned_printer(2.8, kFlatTurn_rad * phase.cos, 0);
    object.qdot[4] = -kFlatTurn_rad * kRate * phase.sin;
    return object;
  };
  return unattended(faulty_paper("far_and_flat", "a flat printer, 2.8 m away, turns to and fro by 3 degrees; no robot",
                                 {}, {{1, kFaultyEnd_s, tracking, none}, {1, kFaultyEnd_s, degraded, ambiguous}}),
                    motion);
}

/// The drawer's first ring moves along its line of sight, and the second is hidden.
inline FaultyPaper end_on_scenario() {
  using enum tracker::TrackingStatus;
  using enum tracker::Reason;
  return unattended(faulty_paper("end_on", "the one ring seen of a drawer comes straight at the camera; no robot",
                                 {{FaultKind::hidden, kFaultFrom_s, kFaultyEnd_s, 5}},
                                 {{kFaultFrom_s, kFaultyEnd_s, degraded, weak_joint}}),
                    [](double t_s) {
                      auto object = turned_printer(1.6, 0, 0);
                      object.q.T_cam_obj.t = {0.06, -0.1, 1.6};
                      const JointMotion drawer = PaperScenario::kDrawer.at(t_s);
                      object.q.joints[0] = drawer.position;
                      object.qdot[6] = drawer.velocity;
                      return object;
                    });
}

/// The robot closes the drawer to its stop, which is that of the model.
inline FaultyPaper closed_drawer_scenario() {
  using enum tracker::TrackingStatus;
  FaultyPaper scenario = faulty_paper("closed_drawer", "the robot pushes the drawer to its stop", {},
                                      {{kFaultFrom_s, kFaultyEnd_s, tracking, tracker::Reason::none}});
  scenario.pull->commands.back().target = 0;
  return scenario;
}

/// A drawer that goes in by 1 cm more than the model says; it does so at 6.8 s. It is held at the limit and told, at
/// first as tracking.
inline FaultyPaper other_range_scenario() {
  using enum tracker::TrackingStatus;
  using enum tracker::Reason;
  const auto motion = [](double t_s) {
    auto object = PaperScenario::at(0);
    constexpr DrawerMotion kShut{.closed_m = 0.02, .open_m = -0.01, .rest_s = kFaultFrom_s, .dwell_s = 9};
    const JointMotion drawer = kShut.at(t_s);
    object.q.joints[0] = drawer.position;
    object.qdot[6] = drawer.velocity;
    return object;
  };
  constexpr double kBeyond_s = 6.75;
  return unattended(faulty_paper("other_range", "a drawer goes in 1 cm farther than the model's; no robot", {},
                                 {{kFaultFrom_s, kBeyond_s + 0.1, tracking, none},
                                  {kBeyond_s, 8, tracking, joint_limit},
                                  {kBeyond_s, kFaultyEnd_s, degraded, joint_limit}}),
                    motion);
}

inline std::vector<FaultyPaper> object_faults() {
  using enum FaultKind;
  using enum tracker::TrackingStatus;
  using enum tracker::Reason;
  constexpr double kFrom_s = kFaultFrom_s, kTo_s = kFaultTo_s, kEnd_s = kFaultyEnd_s;
  return {
      faulty_paper("jammed_drawer", "the drawer jams at 3.5 s: the fingers slip along it, and the eye knows",
                   {{friction, 3.5, kTo_s, 40}}, {{kFrom_s, kEnd_s, tracking, none}}),
      closed_drawer_scenario(),
      other_range_scenario(),
      faulty_paper("other_object", "from 5 s to 8 s every marker is 1 cm from where the model has it",
                   {{warped, kFrom_s, kTo_s, 0.01}},
                   {{kFrom_s, kFrom_s + 0.5, degraded, few_markers},
                    {kFrom_s, kFrom_s + 0.5, degraded, weak_joint},
                    {kFrom_s + 0.45, kTo_s, lost, few_markers},
                    {kFrom_s + 0.45, kTo_s, lost, not_converged},  // the search takes more than a frame
                    {kFrom_s + 0.9, kTo_s, fault, large_residual},
                    {kTo_s, kEnd_s, tracking, none}}),
      far_and_flat_scenario(),
      end_on_scenario(),
  };
}

}  // namespace articam::sim
