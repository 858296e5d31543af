// articam-modelgen: a URDF and its markers, or a camera file -> constexpr tables.
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/modelgen/check_model.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/emit_camera.hpp"
#include "tools/modelgen/parse_number.hpp"
#include "tools/modelgen/read_camera.hpp"
#include "tools/modelgen/source_file.hpp"
#include "tools/report/report.hpp"

namespace {

using namespace articam::modelgen;
using articam::report::Conditions;

constexpr int kDone = 0, kRefused = 1, kWrongUsage = 2;

struct Arguments {
  std::string urdf, markers, camera, name, output, root;
  std::vector<std::string> freeze, points;
  std::string report, report_camera, report_range = "0.5:1.5";
  double report_noise_px = 0.1;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.footer(
      "Example:\n"
      "  articam-modelgen --urdf door.urdf --markers door.markers.yaml --name KitchenDoor -o kitchen_door.hpp\n"
      "writes struct articam::models::KitchenDoor;\n"
      "  articam-modelgen --camera front.yaml --name Front -o front.hpp\n"
      "writes articam::cameras::kFront;\n"
      "  articam-modelgen --urdf door.urdf --markers door.markers.yaml --report door.txt\n"
      "tells before the glue dries what the marks will and will not observe, and how well.\n"
      "Whatever is wrong with the input is told as\n"
      "  file:line: element: reason\n"
      "all of it in one run; then nothing is written.\n"
      "Exit codes: 0 done, 1 input refused, 2 wrong usage.");
  app.set_version_flag("--version", "articam-modelgen " ARTICAM_VERSION);
  CLI::Option* const urdf = app.add_option("--urdf", arguments.urdf, "Shape of the object")->type_name("FILE");
  app.add_option("--markers", arguments.markers, "Markers on its links (YAML)")->type_name("FILE")->needs(urdf);
  app.add_option("--camera", arguments.camera, "Instead of an object: a camera's ROS calibration (YAML)")
      ->type_name("FILE")
      ->excludes(urdf);
  app.add_option("--name", arguments.name, "Name of the C++ type, CamelCase")->type_name("NAME");
  app.add_option("-o,--output", arguments.output, "Header to write")->type_name("FILE");
  app.add_option("--root", arguments.root, "Link that becomes the object's frame")->type_name("LINK")->needs(urdf);
  app.add_option("--freeze", arguments.freeze, "Hold a joint at a value (rad, m); repeatable")
      ->type_name("JOINT=VALUE")
      ->needs(urdf)
      ->allow_extra_args(false);
  app.add_option("--poi", arguments.points, "Add a point without a marker; repeatable")
      ->type_name("NAME=LINK:x,y,z")
      ->needs(urdf)
      ->allow_extra_args(false);
  CLI::Option* const report = app.add_option("--report", arguments.report,
                                             "What the marks will tell, as text, or as JSON if FILE ends in .json")
                                  ->type_name("FILE")
                                  ->needs(urdf);
  app.add_option("--report-camera", arguments.report_camera, "Its camera (default 640x480, focal length 525 px)")
      ->type_name("FILE")
      ->needs(report);
  app.add_option("--report-range", arguments.report_range, "How far off the marks are, m")
      ->type_name("MIN:MAX")
      ->capture_default_str()
      ->needs(report);
  app.add_option("--report-noise", arguments.report_noise_px, "Deviation of a mark's centre, px")
      ->type_name("PX")
      ->capture_default_str()
      ->needs(report)
      ->check(CLI::Range(1e-4, 100.0));
}

/// Empty, or what is wrong with the usage.
std::string parse_options(const Arguments& arguments, ModelOptions& options) {
  if (arguments.urdf.empty() && arguments.camera.empty()) return "--urdf is required, or --camera";
  if (arguments.output.empty() && arguments.report.empty()) return "--output is required, or --report";
  if (!arguments.output.empty() && !is_type_name(arguments.name)) {
    return "--name: '" + arguments.name + "' is no CamelCase name of letters and digits";
  }
  options.root = arguments.root;
  for (const std::string& text : arguments.freeze) {
    const auto freeze = parse_freeze(text);
    if (!freeze) return "--freeze: '" + text + "' is not JOINT=VALUE";
    options.freeze.push_back(*freeze);
  }
  for (const std::string& text : arguments.points) {
    const auto point = parse_point(text);
    if (!point) return "--poi: '" + text + "' is not NAME=LINK:x,y,z";
    options.points.push_back(*point);
  }
  std::error_code ignored;  // a file that does not exist is nobody's input
  for (const std::string& input : {arguments.urdf, arguments.markers, arguments.camera, arguments.report_camera}) {
    if (std::filesystem::equivalent(input, arguments.output, ignored)) return "--output: is one of the inputs";
    if (std::filesystem::equivalent(input, arguments.report, ignored)) return "--report: is one of the inputs";
  }
  return "";
}

/// What is to be written: each text empty where it was not asked for.
struct Outcome {
  std::string header, report;
};

/// The report's camera and range, or nothing when the diagnostics hold an error.
std::optional<Conditions> conditions_of(const Arguments& arguments, Diagnostics& diagnostics) {
  Conditions conditions;
  conditions.camera = articam::report::default_camera();
  conditions.noise_px = arguments.report_noise_px;
  const std::string_view range = arguments.report_range;
  const auto colon = std::min(range.find(':'), range.size());
  const auto least = parse_number(range.substr(0, colon));
  const auto most = parse_number(range.substr(std::min(colon + 1, range.size())));
  if (!least || !most || !(*least > 0.01 && *least <= *most && *most < 100)) {
    diagnostics.error("--report-range", 0, arguments.report_range, "is not MIN:MAX in m, between 0.01 and 100");
    return std::nullopt;
  }
  conditions.min_range_m = *least;
  conditions.max_range_m = *most;
  if (!arguments.report_camera.empty()) {
    const auto camera = read_camera(arguments.report_camera, diagnostics);
    if (!camera) return std::nullopt;
    conditions.camera = *camera;
  }
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
std::optional<Outcome> compile(const Arguments& arguments, const ModelOptions& options, Diagnostics& diagnostics) {
  if (!arguments.camera.empty()) return compile_camera(arguments, diagnostics);
  const auto urdf = read_source(arguments.urdf, diagnostics);
  std::optional<SourceFile> markers;
  if (!arguments.markers.empty()) markers = read_source(arguments.markers, diagnostics);
  const auto conditions = conditions_of(arguments, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const auto model = compile_model({*urdf, markers, arguments.name, options}, diagnostics);
  if (!model) return std::nullopt;
  Outcome outcome;
  if (!arguments.output.empty()) outcome.header = model->header;
  if (!arguments.report.empty()) {
    const articam::report::Report report = articam::report::make_report(*model, *conditions, say);
    outcome.report = arguments.report.ends_with(".json") ? to_json(report) : to_text(report);
  }
  return outcome;
}

/// Whether the file was written, or not asked for.
bool write(const std::string& path, const std::string& text) {
  if (path.empty()) return true;
  const std::string reason = write_whole_file(path, text);
  if (!reason.empty()) std::fprintf(stderr, "%s: output: %s\n", path.c_str(), reason.c_str());
  return reason.empty();
}

int run(const Arguments& arguments, const ModelOptions& options) {
  Diagnostics diagnostics;
  const auto outcome = compile(arguments, options, diagnostics);
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
  ModelOptions options;
  if (const std::string wrong = parse_options(arguments, options); !wrong.empty()) {
    std::fprintf(stderr, "%s\nRun with --help for more information.\n", wrong.c_str());
    return kWrongUsage;
  }
  return run(arguments, options);
}
