// articam-modelgen: a URDF and its markers, or a camera file -> constexpr tables.
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "tools/command_line.hpp"
#include "tools/modelgen/arguments.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/emit_camera.hpp"
#include "tools/modelgen/output_files.hpp"
#include "tools/modelgen/read_camera.hpp"
#include "tools/modelgen/source_file.hpp"
#include "tools/report/report.hpp"

namespace {

using namespace articam::modelgen;
using articam::report::Conditions;

/// What is to be written.
struct Outcome {
  std::vector<OutputFile> files;
  std::string screen;

  /// - is the screen, no path is nothing.
  void put(const std::string& path, const std::string& text) {
    if (path == "-") {
      screen += text;
    } else if (!path.empty()) {
      files.push_back({path, text});
    }
  }
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

/// Tells a person what takes so long: after two seconds, and then once a second.
void say(const char* what, double share) {
  using Clock = std::chrono::steady_clock;
  static Clock::time_point next = Clock::now() + std::chrono::seconds(2);
  if (Clock::now() < next || isatty(STDERR_FILENO) == 0) return;
  next = Clock::now() + std::chrono::seconds(1);
  std::fprintf(stderr, "report: %s, %.0f %% ...\n", what, 100 * share);
}

std::optional<Outcome> compile_camera(const Arguments& arguments, Diagnostics& diagnostics) {
  const auto source = read_source(arguments.camera, diagnostics);
  const auto camera = source ? read_camera(*source, diagnostics) : std::nullopt;
  if (!camera) return std::nullopt;
  Outcome outcome;
  outcome.put(arguments.output, emit_camera(*camera, *source, arguments.name));
  return outcome;
}

/// Nothing when the diagnostics hold an error.
std::optional<Outcome> compile(const Arguments& arguments, const Request& request, Diagnostics& diagnostics) {
  if (!arguments.camera.empty()) return compile_camera(arguments, diagnostics);
  const auto urdf = read_source(arguments.urdf, diagnostics);
  std::optional<SourceFile> markers;
  if (!arguments.markers.empty()) markers = read_source(arguments.markers, diagnostics);
  const bool readable = !diagnostics.has_errors();
  const auto conditions = conditions_of(arguments, request, diagnostics);
  std::optional<CompiledModel> model;
  if (readable) model = compile_model({*urdf, markers, arguments.name, request.options}, diagnostics);
  if (!model || !conditions) return std::nullopt;
  Outcome outcome;
  outcome.put(arguments.output, model->header);
  if (arguments.report.empty()) return outcome;
  const articam::report::Report report = articam::report::make_report(*model, *conditions, say);
  outcome.put(arguments.report, arguments.report.ends_with(".json") ? to_json(report) : to_text(report));
  return outcome;
}

int run(const Arguments& arguments, const Request& request) {
  Diagnostics diagnostics;
  const auto outcome = compile(arguments, request, diagnostics);
  std::fputs(diagnostics.text().c_str(), stderr);
  if (!outcome) return articam::tools::kRefused;
  if (const std::string problem = write_files(outcome->files); !problem.empty()) {
    std::fprintf(stderr, "%s\n", problem.c_str());
    return articam::tools::kRefused;
  }
  const bool shown = std::fputs(outcome->screen.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  return shown ? articam::tools::kDone : articam::tools::kRefused;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Compiles a URDF and its markers, or a camera file, into a C++ header of constexpr tables."};
  Arguments arguments;
  declare(app, arguments);
  if (const auto exit_code = articam::tools::parse(app, argc, argv)) return *exit_code;
  Request request;
  if (const std::string wrong = understand(arguments, request); !wrong.empty())
    return articam::tools::wrong_usage(wrong);
  return run(arguments, request);
}
