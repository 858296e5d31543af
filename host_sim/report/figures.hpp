#pragma once
/// @file  The paper's figures 3 to 7, drawn by gnuplot.

#include <string>
#include <vector>

#include "core/status.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim {

struct Figure {
  std::string caption;
  std::string svg;  ///< to be put into a page as it is; scales with its width
};

/// Error norm; position; roll, pitch and yaw; then each joint. Replaces `figures`.
/// Errors  io_error when the program gnuplot is missing or fails.
Status draw_figures(const RunRecord& run, std::vector<Figure>& figures);

}  // namespace articam::sim
