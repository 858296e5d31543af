#pragma once
/// @file  The folder of results: what a run leaves beside estimates.csv.

#include <filesystem>
#include <functional>
#include <string>

#include "host_sim/report/metrics.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// Writes a whole file or none. Returns why it could not, or nothing.
using WriteFile = std::function<std::string(const std::filesystem::path& path, const std::string& content)>;

/// Writes truth.csv, metrics.json and report.html, with a camera frame taken at `picture_t_s` (see report_html).
/// Without the program gnuplot there is no report.html, not even an old one; the other two are complete. Returns what
/// went wrong, or nothing.
std::string write_report(const std::filesystem::path& folder, const RunRecord& run, const Metrics& metrics,
                         const std::string& picture_svg, double picture_t_s, const WriteFile& write);

/// A few aligned lines for a person.
std::string summary(const RunRecord& run, const Metrics& metrics);

}  // namespace articam::sim
