#pragma once
/// @file  The page that shows a run.

#include <span>
#include <string>

#include "host_sim/report/figures.hpp"
#include "host_sim/report/metrics.hpp"

namespace articam::sim {

/// The contents of report.html: one file that needs nothing else, for a screen of any width and for print.
/// `picture_svg` is a camera frame (see camera_picture), taken at `picture_t_s`.
std::string report_html(const RunRecord& run, const Metrics& metrics, const std::string& picture_svg,
                        double picture_t_s, std::span<const Figure> figures);

}  // namespace articam::sim
