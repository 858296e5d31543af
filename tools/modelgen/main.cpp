// articam-modelgen: a URDF and its markers, or a camera file -> constexpr tables.
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <optional>
#include <string>

#include "tools/modelgen/arguments.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/emit_camera.hpp"
#include "tools/modelgen/read_camera.hpp"
#include "tools/modelgen/source_file.hpp"
#include "tools/report/report.hpp"

namespace {

using namespace articam::modelgen;
using articam::report::Conditions;

constexpr int kDone = 0, kRefused = 1, kWrongUsage = 2;

/// What is to be written: each text empty where it was not asked for.
struct Outcome {
  std::string header, report;
};

/// The report's camera and range, or nothing when the diagnostics hold an error.
std::optional<Conditions> conditions_of(const Arguments& arguments, const Request& request, Diagnostics& diagnostics) {
  Conditions conditions{articam::report::default_camera(), request.min_range_m, request.max_range_m,
                        arguments.report_tilt_deg, arguments.report_noise_px};
  if (arguments.report_camera.empty()) return conditions;
  const auto camera = read_camera(arguments.report_camera, diagnostics);
  if (!camera) return std::nullopt;
  conditions.camera = *camera;
  return conditions;
}

void say(const char* what) {
  if (isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "report: %s ...\n", what);
}

std::optional<Outcome> compile_camera(const Arguments& arguments, Diagnostics& diagnostics) {
  const auto source = read_source(arguments.camera, diagnostics);
  const auto camera = source ? read_camera(*source, diagnostics) : std::nullopt;
  if (!camera) return std::nullopt;
  return Outcome{emit_camera(*camera, *source, arguments.name), ""};
}

/// Nothing when the diagnostics hold an error.
std::optional<Outcome> compile(const Arguments& arguments, const Request& request, Diagnostics& diagnostics) {
  if (!arguments.camera.empty()) return compile_camera(arguments, diagnostics);
  const auto urdf = read_source(arguments.urdf, diagnostics);
  std::optional<SourceFile> markers;
  if (!arguments.markers.empty()) markers = read_source(arguments.markers, diagnostics);
  const auto conditions = conditions_of(arguments, request, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const auto model = compile_model({*urdf, markers, arguments.name, request.options}, diagnostics);
  if (!model) return std::nullopt;
  Outcome outcome;
  if (!arguments.output.empty()) outcome.header = model->header;
  if (!arguments.report.empty()) {
    const articam::report::Report report = articam::report::make_report(*model, *conditions, say);
    outcome.report = arguments.report.ends_with(".json") ? to_json(report) : to_text(report);
  }
  return outcome;
}

/// Whether the file (or, for -, the screen) was written, or not asked for.
bool write(const std::string& path, const std::string& text) {
  if (path.empty()) return true;
  if (path == "-") return std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  const std::string reason = write_whole_file(path, text);
  if (!reason.empty()) std::fprintf(stderr, "%s: output: %s\n", path.c_str(), reason.c_str());
  return reason.empty();
}

int run(const Arguments& arguments, const Request& request) {
  Diagnostics diagnostics;
  const auto outcome = compile(arguments, request, diagnostics);
  std::fputs(diagnostics.text().c_str(), stderr);
  if (!outcome) return kRefused;
  const bool written = write(arguments.output, outcome->header) && write(arguments.report, outcome->report);
  return written ? kDone : kRefused;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Compiles a URDF and its markers, or a camera file, into a C++ header of constexpr tables."};
  Arguments arguments;
  declare(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? kDone : kWrongUsage;
  }
  Request request;
  if (const std::string wrong = understand(arguments, request); !wrong.empty()) {
    std::fprintf(stderr, "%s\nRun with --help for more information.\n", wrong.c_str());
    return kWrongUsage;
  }
  return run(arguments, request);
}
