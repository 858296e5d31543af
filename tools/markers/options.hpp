#pragma once
/// @file  What the user asks of articam-markers.

#include <optional>
#include <string>

#include "tools/markers/paper.hpp"
#include "tools/markers/sheet_files.hpp"
#include "tools/modelgen/model_options.hpp"

namespace articam::markers {

struct Options {
  std::string model;          ///< of static_models; empty: the two files
  std::string urdf, markers;  ///< files
  modelgen::ModelOptions modelling;
  bool list{};
  std::string output;
  Format format{};
  Paper paper;
  double margin_mm{10};
};

/// The exit code when the program has nothing more to do: help and version are printed, wrong usage is told.
std::optional<int> parse_options(int argc, const char* const* argv, Options& out);

}  // namespace articam::markers
