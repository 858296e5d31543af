// articam-modelgen: a URDF and its markers, or a camera file -> constexpr tables.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/modelgen/check_model.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/emit_camera.hpp"
#include "tools/modelgen/read_camera.hpp"
#include "tools/modelgen/source_file.hpp"

namespace {

using namespace articam::modelgen;

constexpr int kDone = 0, kRefused = 1, kWrongUsage = 2;

struct Arguments {
  std::string urdf, markers, camera, name, output, root, report;
  std::vector<std::string> freeze, points;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.footer(
      "Example:\n"
      "  articam-modelgen --urdf door.urdf --markers door.markers.yaml --name KitchenDoor -o kitchen_door.hpp\n"
      "writes struct articam::models::KitchenDoor;\n"
      "  articam-modelgen --camera front.yaml --name Front -o front.hpp\n"
      "writes articam::cameras::kFront. Whatever is wrong with the input is told as\n"
      "  file:line: element: reason\n"
      "all of it in one run; then nothing is written.\n"
      "Exit codes: 0 done, 1 input refused, 2 wrong usage.");
  app.set_version_flag("--version", "articam-modelgen " ARTICAM_VERSION);
  CLI::Option* const urdf = app.add_option("--urdf", arguments.urdf, "Shape of the object")->type_name("FILE");
  app.add_option("--markers", arguments.markers, "Markers on its links (YAML)")->type_name("FILE")->needs(urdf);
  app.add_option("--camera", arguments.camera, "Instead of an object: a camera's ROS calibration (YAML)")
      ->type_name("FILE")
      ->excludes(urdf);
  app.add_option("--name", arguments.name, "Name of the C++ type, CamelCase")->required()->type_name("NAME");
  app.add_option("-o,--output", arguments.output, "Header to write")->required()->type_name("FILE");
  app.add_option("--root", arguments.root, "Link that becomes the object's frame")->type_name("LINK")->needs(urdf);
  app.add_option("--freeze", arguments.freeze, "Hold a joint at a value (rad, m); repeatable")
      ->type_name("JOINT=VALUE")
      ->needs(urdf)
      ->allow_extra_args(false);
  app.add_option("--poi", arguments.points, "Add a point without a marker; repeatable")
      ->type_name("NAME=LINK:x,y,z")
      ->needs(urdf)
      ->allow_extra_args(false);
  app.add_option("--report", arguments.report, "Not supported yet")->type_name("FILE");
}

/// Empty, or what is wrong with the usage.
std::string parse_options(const Arguments& arguments, ModelOptions& options) {
  if (arguments.urdf.empty() && arguments.camera.empty()) return "--urdf is required, or --camera";
  if (!is_type_name(arguments.name)) {
    return "--name: '" + arguments.name + "' is no CamelCase name of letters and digits";
  }
  if (!arguments.report.empty()) return "--report: not supported yet";
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
  for (const std::string& input : {arguments.urdf, arguments.markers, arguments.camera}) {
    if (std::filesystem::equivalent(input, arguments.output, ignored)) return "--output: is one of the inputs";
  }
  return "";
}

/// The header, or nothing when the diagnostics hold an error.
std::optional<std::string> compile(const Arguments& arguments, const ModelOptions& options, Diagnostics& diagnostics) {
  if (!arguments.camera.empty()) {
    const auto source = read_source(arguments.camera, diagnostics);
    const auto camera = source ? read_camera(*source, diagnostics) : std::nullopt;
    return camera ? std::optional{emit_camera(*camera, *source, arguments.name)} : std::nullopt;
  }
  const auto urdf = read_source(arguments.urdf, diagnostics);
  std::optional<SourceFile> markers;
  if (!arguments.markers.empty()) markers = read_source(arguments.markers, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const auto model = compile_model({*urdf, markers, arguments.name, options}, diagnostics);
  return model ? std::optional{model->header} : std::nullopt;
}

int run(const Arguments& arguments, const ModelOptions& options) {
  Diagnostics diagnostics;
  const auto header = compile(arguments, options, diagnostics);
  std::fputs(diagnostics.text().c_str(), stderr);
  if (!header) return kRefused;
  const std::string reason = write_whole_file(arguments.output, *header);
  if (reason.empty()) return kDone;
  std::fprintf(stderr, "%s: output: %s\n", arguments.output.c_str(), reason.c_str());
  return kRefused;
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
