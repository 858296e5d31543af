#pragma once
/// @file  The tables of the page.

#include <span>
#include <string>
#include <string_view>

#include "host_sim/report/metrics.hpp"
#include "host_sim/report/pull_metrics.hpp"

namespace articam::sim {

/// Errors of the run, of the tracker's other mode and of the SVD baseline side by side.
std::string error_table(const RunRecord& run, const Metrics& metrics);

/// Frames by what the tracker said of itself, residual, rate of convergence, time of a step.
std::string tracker_table(const RunRecord& run, const Metrics& metrics);

/// In which PullMetrics count the joint that is pulled: mm or mrad.
std::string_view pulled_unit(const RunRecord& run);

/// A column a feedback: how fast, how far beyond, how exact, how rough.
std::string feedback_table(const RunRecord& run, std::span<const FeedbackRun> feedbacks);

}  // namespace articam::sim
