// articam-picture: an object as its camera sees it at the start, drawn from its URDF and its markers.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

#include "tools/command_line.hpp"
#include "tools/modelgen/output_files.hpp"
#include "tools/modelgen/read_camera.hpp"
#include "tools/picture/draw.hpp"

namespace {

using namespace articam;

struct Arguments {
  std::string urdf, markers, camera, output;
  int width_px = 480;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.footer(
      "The pose and the joints are the q0 of the markers file. Boxes, cylinders and spheres are drawn, meshes are "
      "not.\n"
      "A marker that is turned away, has something before it, or is not wholly in the picture is named as a warning.\n"
      "Example:\n"
      "  articam-picture --urdf door.urdf --markers door.markers.yaml --camera front.yaml -o door.png\n"
      "Exit codes: 0 done, 1 input refused, 2 wrong usage.");
  app.set_version_flag("--version", "articam-picture " ARTICAM_VERSION);
  app.add_option("--urdf", arguments.urdf, "Shape of the object")->required()->type_name("FILE");
  app.add_option("--markers", arguments.markers, "Markers on its links, and q0 (YAML)")->required()->type_name("FILE");
  app.add_option("--camera", arguments.camera, "The camera's ROS calibration (YAML); its distortion is left out")
      ->required()
      ->type_name("FILE");
  app.add_option("-o,--output", arguments.output, "PNG to write")->required()->type_name("FILE");
  app.add_option("--width", arguments.width_px, "Width of the picture, px")
      ->check(CLI::Range(16, 4096))
      ->capture_default_str();
}

/// Empty when the diagnostics hold an error.
std::string picture_for(const Arguments& arguments, modelgen::Diagnostics& diagnostics) {
  const auto camera = modelgen::read_camera(arguments.camera, diagnostics);
  const auto urdf = modelgen::read_source(arguments.urdf, diagnostics);
  const auto markers = modelgen::read_source(arguments.markers, diagnostics);
  if (!camera || !urdf || !markers) return {};
  const auto scene = picture::scene_of(*urdf, *markers, diagnostics);
  if (!scene) return {};
  const auto warn = [&](const std::string& marker, const char* reason) {
    diagnostics.warning(arguments.markers, 0, modelgen::title("marker", marker), reason);
  };
  for (const std::string& marker : picture::hidden_markers(*scene)) warn(marker, "is turned away, or behind something");
  for (const std::string& marker : picture::cut_markers(*scene, *camera)) warn(marker, "is not wholly in the picture");
  return picture::draw(*scene, *camera, arguments.width_px);
}

int run(const Arguments& arguments) {
  modelgen::Diagnostics diagnostics;
  const std::string png = picture_for(arguments, diagnostics);
  std::fputs(diagnostics.text().c_str(), stderr);
  if (png.empty()) return tools::kRefused;
  const std::string problem = modelgen::write_files({{arguments.output, png}});
  if (problem.empty()) return tools::kDone;
  std::fprintf(stderr, "%s\n", problem.c_str());
  return tools::kRefused;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Draws an object as its camera sees it at the start, from its URDF and its markers."};
  Arguments arguments;
  declare(app, arguments);
  if (const auto exit_code = tools::parse(app, argc, argv)) return *exit_code;
  return run(arguments);
}
