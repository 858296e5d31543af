#pragma once
/// @file  All figures of a report, drawn by gnuplot.

#include <span>
#include <vector>

#include "core/status.hpp"
#include "host_sim/report/figure.hpp"
#include "host_sim/report/pull_metrics.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// In the order of the page's chapters.
struct Figures {
  std::vector<Figure> paper;   ///< see paper_figures
  std::vector<Figure> robot;   ///< see pull_figures
  std::vector<Figure> counts;  ///< see histogram_figures
};

/// Errors  io_error when the program gnuplot is missing or fails.
Status draw_figures(const RunRecord& run, std::span<const FeedbackRun> feedbacks, Figures& figures);

}  // namespace articam::sim
