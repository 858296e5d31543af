#pragma once
/// @file  The paper's figures 3 to 7, and what a ground truth adds to them.

#include <vector>

#include "host_sim/report/run_table.hpp"

namespace articam::sim {

/// 3: norm of the error; 4: position of the base; 5: its roll, pitch and yaw; from 6 on: each joint. Figures 4 and 5
/// are each followed by the estimate's error inside its band of three standard deviations, which each joint's has in
/// its own.
std::vector<Plan> paper_figures(const RunRecord& run, const RunTable& table);

}  // namespace articam::sim
