#pragma once
/// @file  The true configuration of every frame.

#include <string>

#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// The contents of truth.csv: frame,t_s,px,py,pz,qw,qx,qy,qz and the joints. Pose of {obj} in {cam}; m, rad, s.
std::string truth_csv(const RunRecord& run);

}  // namespace articam::sim
