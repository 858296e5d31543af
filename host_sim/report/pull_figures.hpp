#pragma once
/// @file  What the robot made of what it was told.

#include <span>
#include <vector>

#include "host_sim/report/pull_metrics.hpp"
#include "host_sim/report/run_table.hpp"

namespace articam::sim {

/// The command and the true joint by each feedback; what each told the controller wrongly; the force of the hand in the
/// first. Nothing without a feedback.
std::vector<Plan> pull_figures(const RunRecord& run, std::span<const FeedbackRun> feedbacks);

}  // namespace articam::sim
