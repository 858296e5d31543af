#pragma once
/// @file  The page that shows a run.

#include <span>
#include <string>
#include <vector>

#include "host_sim/report/figures.hpp"
#include "host_sim/report/metrics.hpp"
#include "host_sim/report/pull_metrics.hpp"

namespace articam::sim {

/// What a run has left.
struct Report {
  const RunRecord& run;
  std::vector<Figure> pictures;          ///< camera frames, see take_pictures
  std::vector<FeedbackRun> feedbacks{};  ///< with a robot: the run's own first, then those it is compared with
};

/// The contents of report.html: one file that needs nothing else, for a screen of any width and for print.
std::string report_html(const Report& report, const Metrics& metrics, const Figures& figures);

}  // namespace articam::sim
