#pragma once
/// @file  The folder of results: what a run leaves beside estimates.csv.

#include <filesystem>
#include <functional>
#include <string>

#include "host_sim/report/metrics.hpp"
#include "host_sim/report/report_html.hpp"

namespace articam::sim {

/// Writes a whole file or none. Returns why it could not, or nothing.
using WriteFile = std::function<std::string(const std::filesystem::path& path, const std::string& content)>;

/// Writes truth.csv, metrics.json, every picture and figure of the page as an SVG of its own into `figures/`, a folder
/// that must exist, and report.html. Without the program gnuplot there are no figures and no report.html, not even an
/// old one; the other two are complete. Returns what went wrong, or nothing.
std::string write_report(const std::filesystem::path& folder, const Report& report, const Metrics& metrics,
                         const WriteFile& write);

/// A few aligned lines for a person.
std::string summary(const RunRecord& run, const Metrics& metrics);

}  // namespace articam::sim
