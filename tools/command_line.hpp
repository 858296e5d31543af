#pragma once
/// @file  What the command lines of the programs here have in common.

#include <CLI/CLI.hpp>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace articam::tools {

inline constexpr int kDone = 0, kRefused = 1, kWrongUsage = 2;  ///< exit codes

inline int wrong_usage(const std::string& reason) {
  std::fprintf(stderr, "%s\nRun with --help for more information.\n", reason.c_str());
  return kWrongUsage;
}

/// The exit code when the program has nothing more to do: help and version are printed, wrong usage is told.
inline std::optional<int> parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& stop) {
    const std::vector<std::string> unknown = app.remaining();
    // Of `--udrf door.urdf` the slip is told, and not that --urdf is missing.
    if (stop.get_exit_code() != 0 && !unknown.empty()) return wrong_usage("'" + unknown[0] + "' is not expected");
    return app.exit(stop) == 0 ? kDone : kWrongUsage;
  }
}

}  // namespace articam::tools
