#pragma once
/// @file  How often which error, how honest the claims, how long a step: counted, not over time.

#include <vector>

#include "host_sim/report/run_table.hpp"

namespace articam::sim {

/// Sizes of errors of every estimator; the default's errors by their claimed deviations; times of a step. After
/// kEvaluatedFrom_s.
std::vector<Plan> histogram_figures(const RunRecord& run, const RunTable& table);

}  // namespace articam::sim
