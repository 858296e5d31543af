#pragma once
/// @file  What can go wrong with the paper's experiment, one fault each, and what must then be said.

#include "host_sim/scenarios/camera_faults.hpp"
#include "host_sim/scenarios/image_faults.hpp"
#include "host_sim/scenarios/object_faults.hpp"

namespace articam::sim {

inline std::vector<FaultyPaper> fault_scenarios() {
  std::vector<FaultyPaper> all = camera_faults();
  for (auto more : {image_faults(), object_faults()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace articam::sim
