#pragma once
/// @file  Images that show less than they should, or more, one fault each, and what must then be said.

#include "host_sim/scenarios/faulty_paper.hpp"

namespace articam::sim {

/// The robot stands on the left of the printer and faces right, so that its forearm comes before the drawer's first
/// ring while the drawer is open.
inline FaultyPaper hand_in_view_scenario() {
  using enum tracker::TrackingStatus;
  FaultyPaper scenario = faulty_paper("hand_in_view", "the robot's forearm hides a ring of the drawer for seconds", {},
                                      {{1, kFaultyEnd_s, tracking, tracker::Reason::none}});
  scenario.pull->R_obj_base << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  scenario.pull->posture = {-0.41, -0.26, -0.5, -2.08, -0.12, 0.1, 0.1};
  return scenario;
}

inline FaultyPaper rolling_shutter_scenario() {
  using enum tracker::TrackingStatus;
  FaultyPaper scenario = faulty_paper("rolling_shutter", "rows are exposed one after the other, in 20 ms", {}, {});
  scenario.camera.readout_time_s = 0.02;
  scenario.expected = {{1, kFaultyEnd_s, tracking, tracker::Reason::none}};
  return scenario;
}

inline std::vector<FaultyPaper> image_faults() {
  using enum FaultKind;
  using enum tracker::TrackingStatus;
  using enum tracker::Reason;
  constexpr double kFrom_s = kFaultFrom_s, kTo_s = kFaultTo_s, kEnd_s = kFaultyEnd_s;
  return {
      faulty_paper("hidden_markers", "no marker is seen", {{hidden, kFrom_s, kTo_s, 0}},
                   {{kFrom_s, kFrom_s + 0.6, coasting, few_markers},
                    {kFrom_s + 0.45, kTo_s, lost, few_markers},
                    {kTo_s, kEnd_s, tracking, none}}),
      faulty_paper("hidden_drawer", "of the drawer no marker is seen", {{hidden, kFrom_s, kTo_s, 4}},
                   {{kFrom_s, kTo_s, degraded, weak_joint}, {kTo_s, kEnd_s, tracking, none}}),
      hand_in_view_scenario(),
      faulty_paper("planted_rings", "four rings that belong to nobody drift by", {{planted, kFrom_s, kTo_s, 4}},
                   {{kFrom_s, kEnd_s, tracking, none}, {kFrom_s, kTo_s, tracking, outlier}}),
      faulty_paper("moved_marker", "a marker has moved by 2 cm", {{moved, kFrom_s, kTo_s, 0.02}},
                   {{kFrom_s, kTo_s, tracking, outlier}, {kFrom_s, kEnd_s, tracking, none}}),
      faulty_paper("overexposure", "twice too much light", {{exposure, kFrom_s, kTo_s, 2}},
                   {{kFrom_s, kTo_s, tracking, overexposed},
                    {kFrom_s, kTo_s, degraded, overexposed},
                    {kTo_s, kEnd_s, tracking, none}}),
      faulty_paper("underexposure", "a tenth of the light", {{exposure, kFrom_s, kTo_s, 0.1}},
                   {{kFrom_s, kEnd_s, tracking, none},
                    {kFrom_s, kTo_s, tracking, underexposed},
                    {kFrom_s, kTo_s, degraded, underexposed},
                    {kFrom_s, kTo_s, degraded, not_converged}}),
      faulty_paper("flicker", "the light swings between half and 1.3 of what is right, five times a second",
                   {{flicker, kFrom_s, kTo_s, 5}},
                   {{kFrom_s, kEnd_s, tracking, none}, {kFrom_s, kTo_s, tracking, overexposed}}),
      faulty_paper("dusk_and_dawn", "the light does so slowly, all the time", {{flicker, 0, kEnd_s, 0.2}},
                   {{1, kEnd_s, tracking, none}, {1, kEnd_s, tracking, overexposed}}),
      faulty_paper("blur", "out of focus: sigma of 4 px", {{blur, kFrom_s, kTo_s, 4}},
                   {{kFrom_s, kTo_s, tracking, blurred}, {kTo_s, kEnd_s, tracking, none}}),
      rolling_shutter_scenario(),
  };
}

}  // namespace articam::sim
