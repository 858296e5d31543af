#pragma once
/// @file  The paper's experiment, short, with something that goes wrong in the middle.

#include <string_view>
#include <utility>
#include <vector>

#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {

using FaultyPaper = Scenario<models::PrinterDrawer>;

/// Control is on from 2 s, the drawer opens at 3 s and closes at 9 s; most faults last from 5 s to 8 s.
inline constexpr double kFaultFrom_s = 5, kFaultTo_s = 8, kFaultyEnd_s = 14;

/// Before the fault everything must be well.
inline FaultyPaper faulty_paper(std::string_view name, std::string_view summary, std::vector<Fault> faults,
                                std::vector<Expected> expected) {
  auto scenario = paper_scenario();
  scenario.name = name;
  scenario.summary = summary;
  scenario.duration_s = kFaultyEnd_s;
  scenario.rest_s = 2;
  scenario.pull->commands = {{2, 0.02}, {3, 0.10}, {9, 0.04}};
  scenario.faults = std::move(faults);
  scenario.expected = std::move(expected);
  scenario.expected.push_back({1, kFaultFrom_s, tracker::TrackingStatus::tracking, tracker::Reason::none});
  return scenario;
}

/// Without a robot: a printer that moves by itself.
inline FaultyPaper unattended(FaultyPaper scenario, std::function<ObjectState<models::PrinterDrawer>(double)> motion) {
  scenario.pull.reset();
  scenario.motion = std::move(motion);
  scenario.rest = scenario.motion(0);
  return scenario;
}

}  // namespace articam::sim
