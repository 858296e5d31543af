#pragma once
/// @file  What can go wrong with the paper's experiment, one fault each, and what must then be said.

#include <utility>
#include <vector>

#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {

/// Fourteen seconds: control from 2 s on, the drawer opens at 3 s and closes at 9 s; the fault is from 5 s to 8 s.
inline std::vector<Scenario<models::PrinterDrawer>> fault_scenarios() {
  using enum FaultKind;
  using enum tracker::TrackingStatus;
  using enum tracker::Reason;
  constexpr double kFrom_s = 5, kTo_s = 8, kEnd_s = 14;
  std::vector<Scenario<models::PrinterDrawer>> all;
  const auto add = [&](std::string_view name, std::string_view summary, Fault fault, std::vector<Expected> expected) {
    auto scenario = paper_scenario();
    scenario.name = name;
    scenario.summary = summary;
    scenario.duration_s = kEnd_s;
    scenario.rest_s = 2;
    scenario.pull->commands = {{2, 0.02}, {3, 0.10}, {9, 0.04}};
    scenario.faults = {fault};
    scenario.expected = std::move(expected);
    scenario.expected.push_back({1, kFrom_s, tracking, none});
    all.push_back(std::move(scenario));
  };
  add("dropped_frames", "half of the frames are lost", {dropped, kFrom_s, kTo_s, 0.5},
      {{kFrom_s, kEnd_s, tracking, none},
       {kFrom_s, kTo_s, coasting, no_frame},          // two in a row
       {kFrom_s, kTo_s, degraded, camera_stalled}});  // three
  add("late_frames", "every frame arrives 120 ms late", {late, kFrom_s, kTo_s, 0.12},
      {{kFrom_s, kFrom_s + 0.2, coasting, no_frame},
       {kFrom_s, kFrom_s + 0.2, degraded, camera_stalled},
       {kFrom_s, kTo_s + 0.1, tracking, late_result},
       {kTo_s, kEnd_s, tracking, none}});
  add("repeated_frames", "every frame comes twice", {repeated, kFrom_s, kTo_s, 1},
      {{kFrom_s, kEnd_s, tracking, none}, {kFrom_s, kTo_s, coasting, stale_frame}});
  add("silent_camera", "the camera gives nothing", {silent, kFrom_s, kTo_s, 1},
      {{kFrom_s, kFrom_s + 0.15, coasting, no_frame},
       {kFrom_s, kFrom_s + 0.4, degraded, camera_stalled},
       {kFrom_s + 0.3, kTo_s + 0.1, lost, camera_stalled},
       {kTo_s, kEnd_s, tracking, none}});
  add("unplugged_camera", "the camera is unplugged, and plugged in again", {unplugged, kFrom_s, kTo_s, 1},
      {{kFrom_s, kTo_s, lost, camera_gone},
       {kTo_s, kTo_s + 0.1, lost, camera_stalled},
       {kTo_s, kEnd_s, tracking, none}});
  add("hidden_markers", "no marker is seen", {hidden, kFrom_s, kTo_s, 0},
      {{kFrom_s, kFrom_s + 0.6, coasting, few_markers},
       {kFrom_s + 0.45, kTo_s, lost, few_markers},
       {kTo_s, kEnd_s, tracking, none}});
  add("hidden_drawer", "of the drawer no marker is seen", {hidden, kFrom_s, kTo_s, 4},
      {{kFrom_s, kTo_s, degraded, weak_joint}, {kTo_s, kEnd_s, tracking, none}});
  add("planted_rings", "four rings that belong to nobody drift by", {planted, kFrom_s, kTo_s, 4},
      {{kFrom_s, kEnd_s, tracking, none}, {kFrom_s, kTo_s, tracking, outlier}});
  add("moved_marker", "a marker has moved by 2 cm", {moved, kFrom_s, kTo_s, 0.02},
      {{kFrom_s, kTo_s, tracking, outlier}, {kFrom_s, kEnd_s, tracking, none}});
  add("overexposure", "twice too much light", {exposure, kFrom_s, kTo_s, 2},
      {{kFrom_s, kEnd_s, tracking, none},
       {kFrom_s, kTo_s, degraded, weak_joint},
       {kFrom_s, kTo_s, degraded, ambiguous}});
  add("underexposure", "a tenth of the light", {exposure, kFrom_s, kTo_s, 0.1},
      {{kFrom_s, kEnd_s, tracking, none}, {kFrom_s, kTo_s, degraded, not_converged}});
  add("blur", "out of focus: sigma of 4 px", {blur, kFrom_s, kTo_s, 4}, {{kFrom_s, kEnd_s, tracking, none}});
  add("jammed_drawer", "the drawer jams at 3.5 s: the fingers slip along it, and the eye knows",
      {friction, 3.5, kTo_s, 40}, {{kFrom_s, kEnd_s, tracking, none}});
  return all;
}

}  // namespace articam::sim
