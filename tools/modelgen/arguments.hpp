#pragma once
/// @file  The command line of articam-modelgen.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tools/modelgen/model_options.hpp"

namespace articam::modelgen {

struct Arguments {
  std::string urdf, markers, camera, name, output, root;
  std::vector<std::string> freeze, points;
  std::string report, report_camera, report_range = "0.5:1.5";
  double report_tilt_deg = 60, report_noise_px = 0.1;
};

/// What the texts of the arguments mean.
struct Request {
  ModelOptions options;
  double min_range_m{}, max_range_m{};
};

void declare(CLI::App& app, Arguments& arguments);

/// Empty, or what is wrong with the usage.
std::string understand(const Arguments& arguments, Request& request);

}  // namespace articam::modelgen
