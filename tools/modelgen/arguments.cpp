#include "tools/modelgen/arguments.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "tools/modelgen/check_model.hpp"
#include "tools/modelgen/parse_number.hpp"

namespace articam::modelgen {
namespace {

namespace fs = std::filesystem;

std::string understand_options(const Arguments& arguments, ModelOptions& options) {
  options.root = arguments.root;
  for (const std::string& text : arguments.freeze) {
    const auto freeze = parse_freeze(text);
    if (!freeze) return "--freeze: '" + text + "' is not JOINT=VALUE, a number up to 1e6";
    options.freeze.push_back(*freeze);
  }
  for (const std::string& text : arguments.points) {
    const auto point = parse_point(text);
    if (!point) return "--poi: '" + text + "' is not NAME=LINK:x,y,z, numbers up to 1e6";
    options.points.push_back(*point);
  }
  return "";
}

/// MIN:MAX
bool understand_range(std::string_view text, Request& request) {
  const auto colon = std::min(text.find(':'), text.size());
  const auto least = parse_number(text.substr(0, colon));
  const auto most = parse_number(text.substr(std::min(colon + 1, text.size())));
  if (!least || !most || !(*least > 0.01 && *least <= *most && *most < 100)) return false;
  request.min_range_m = *least;
  request.max_range_m = *most;
  return true;
}

/// Whether two names are one file, also where it does not exist yet.
bool is_same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) || fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

std::string check_files(const Arguments& arguments) {
  for (const std::string& input : {arguments.urdf, arguments.markers, arguments.camera, arguments.report_camera}) {
    if (is_same_file(input, arguments.output)) return "--output: is one of the inputs";
    if (is_same_file(input, arguments.report)) return "--report: is one of the inputs";
  }
  return is_same_file(arguments.output, arguments.report) ? "--report: is the same file as --output" : "";
}

}  // namespace

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
  CLI::Option* const report =
      app.add_option("--report", arguments.report,
                     "What the marks will tell, as text, or as JSON if FILE ends in .json; - is the screen")
          ->type_name("FILE")
          ->needs(urdf);
  app.add_option("--report-camera", arguments.report_camera, "Its camera (default 640x480, focal length 525 px)")
      ->type_name("FILE")
      ->needs(report);
  app.add_option("--report-range", arguments.report_range, "How far off the marks are, m")
      ->type_name("MIN:MAX")
      ->capture_default_str()
      ->needs(report);
  app.add_option("--report-tilt", arguments.report_tilt_deg, "How far the camera stands from the marks' front, deg")
      ->type_name("MAX")
      ->capture_default_str()
      ->needs(report)
      ->check(CLI::Range(0.0, 80.0));
  app.add_option("--report-noise", arguments.report_noise_px, "Deviation of a mark's centre, px")
      ->type_name("PX")
      ->capture_default_str()
      ->needs(report)
      ->check(CLI::Range(1e-4, 100.0));
}

std::string understand(const Arguments& arguments, Request& request) {
  if (arguments.urdf.empty() && arguments.camera.empty()) return "--urdf is required, or --camera";
  if (arguments.output.empty() && arguments.report.empty()) return "--output is required, or --report";
  if (!arguments.output.empty() && arguments.name.empty()) return "--name is required with --output";
  if (!arguments.output.empty() && !is_type_name(arguments.name)) {
    return "--name: '" + arguments.name + "' is no CamelCase name of letters and digits";
  }
  if (!understand_range(arguments.report_range, request)) {
    return "--report-range: '" + arguments.report_range + "' is not MIN:MAX in m, between 0.01 and 100";
  }
  const std::string wrong = understand_options(arguments, request.options);
  return wrong.empty() ? check_files(arguments) : wrong;
}

}  // namespace articam::modelgen
