/// @file  articam-replay: the firmware's tracker over recorded frames.

#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>

#include "hal/app/recording_job.hpp"
#include "hal/app/replay_job.hpp"
#include "static_models/registry.hpp"
#include "tools/modelgen/read_camera.hpp"

namespace {

using articam::app::ReplayOptions;

constexpr const char* kExample = R"(
Example
  articam-replay mire --camera static_models/cameras/mire_384x288.yaml \
      --frames /usr/share/visp-images-data/ViSP-images/mire-2 --max-frames 250 -o est.csv

  articam-replay printer_drawer --recording run.rec -o est.csv       what a board recorded, again

  articam-replay printer_drawer --camera static_models/cameras/xtion_vga.yaml --frames run -o est.csv \
      --virtual marker_distance --identify fixed.urdf --identify fixed.markers.yaml
  articam-replay printer_drawer --recording run.rec -o est.csv --identify fixed.markers.yaml

--identify adjusts all frames at once and writes what is constant in them, with standard deviations: FILE.urdf has the
constant joints fixed where they were found, FILE.yaml every marker at its place on its link. It also says whether the
camera file is right. Move the camera all around the object, and its joints over their range; markers' directions are
taken from the URDF.

MODEL is a folder of static_models; --list names them. Frames are binary 8-bit PGM files, sorted by name; quote a
pattern. q0 is where the search begins: base pose in the camera frame (x right, y down, z forward; m), quaternion
w x y z, then the joints in the order that articam-probe MODEL prints.
Exit codes: 0 done, 1 an input is refused or the job failed, 2 wrong usage.)";

std::vector<std::filesystem::path> all_frames(const std::vector<std::string>& sources, int repeat) {
  std::vector<std::filesystem::path> files;
  for (const auto& source : sources) {
    const auto found = articam::hal::find_frames(source);
    files.insert(files.end(), found.begin(), found.end());
  }
  std::sort(files.begin(), files.end());
  const std::size_t once = files.size();
  files.reserve(once * static_cast<std::size_t>(repeat));
  for (int i = 1; i < repeat; ++i) files.insert(files.end(), files.begin(), files.begin() + static_cast<long>(once));
  return files;
}

int fail(const std::string& message) {
  fmt::print(stderr, "articam-replay: {}\n", message);
  return 1;
}

/// The exit code of `job.operator()<Model>()`, which returns what went wrong, or nothing.
template <class Job>
int run_for(const std::string& model, Job&& job) {
  std::string problem;
  if (articam::models::visit_model(model, [&]<class Model>() { problem = job.template operator()<Model>(); })) {
    return problem.empty() ? 0 : fail(problem);
  }
  fail(fmt::format("no model '{}'; known: {}", model, fmt::join(articam::models::kStaticModelNames, ", ")));
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Estimates an object's configuration from recorded camera frames, one CSV row a frame.",
               "articam-replay"};
  ReplayOptions options;
  articam::app::RecordingOptions recording;
  std::string model, camera_file;
  std::vector<std::string> sources;
  std::size_t max_frames = 0;
  int repeat = 1;
  bool list = false;
  app.footer(kExample);
  app.set_version_flag("--version", "articam-replay " ARTICAM_VERSION);
  auto* model_option = app.add_option("MODEL", model, "the object, a folder of static_models");
  app.add_flag("--list", list, "name the models and stop");
  auto* camera_option = app.add_option("--camera", camera_file, "ROS calibration YAML of the camera");
  auto* frames_option = app.add_option("--frames", sources, "folder, pattern or files of PGM frames");
  app.add_option("--repeat", repeat, "play the frames so many times, as one recording")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  auto* recording_option = app.add_option("--recording", recording.recording,
                                          "instead of camera and frames: what articam-board --record wrote");
  app.add_option("--recorded-frames", recording.frames, "its frames, to look at them again")->needs(recording_option);
  app.add_option("--max-frames", max_frames, "stop after so many frames (0: all)");
  app.add_option("--fps", options.rate_hz, "frames per second")->capture_default_str()->check(CLI::Range(0.1, 10000.0));
  app.add_option("--q0", options.q0, "'px py pz qw qx qy qz q1 q2 ...' (default: the model's own)");
  app.add_option("--mode", options.mode, "default: iterated in every frame; paper: one step a frame")
      ->transform(CLI::CheckedTransformer(std::map<std::string, articam::tracker::Mode>{
          {"default", articam::tracker::Mode::standard}, {"paper", articam::tracker::Mode::paper}}))
      ->option_text("default|paper");
  auto* output_option = app.add_option("-o,--output", options.output, "estimates.csv to write");
  app.add_option("--overlay", options.overlay_folder, "also draw every frame with its marks into this folder (PNG)");
  auto* identify_option =
      app.add_option("--identify", options.identify.outputs,
                     "write FILE.urdf or FILE.yaml with what the recording tells of the object; may be repeated");
  app.add_option("--virtual", options.identify.still,
                 "a joint that stands for a constant; may be repeated (default: those that stand still)")
      ->needs(identify_option);
  app.add_option("--urdf", options.identify.urdf, "the model's source (default: static_models/MODEL/MODEL.urdf)")
      ->needs(identify_option);
  app.add_option("--markers", options.identify.markers, "likewise (default: static_models/MODEL/MODEL.markers.yaml)")
      ->needs(identify_option);
  for (const char* const other :
       {"--camera", "--frames", "--repeat", "--max-frames", "--fps", "--q0", "--mode", "--overlay"}) {
    recording_option->excludes(app.get_option(other));  // all of that is in the recording
  }
  try {
    app.parse(argc, argv);
    if (!list) {
      std::vector<const CLI::Option*> required{model_option, output_option};
      if (recording_option->count() == 0) required.insert(required.end(), {camera_option, frames_option});
      for (const auto* option : required) {
        if (option->count() == 0) throw CLI::RequiredError(option->get_name());
      }
    }
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  if (list) {
    for (const auto name : articam::models::kStaticModelNames) fmt::print("{}\n", name);
    return 0;
  }

  articam::identify::JobOptions& identify = options.identify;
  identify.camera_file = camera_file;
  const std::string stem = "static_models/" + model + "/" + model;
  if (identify.urdf.empty()) identify.urdf = stem + ".urdf";
  if (identify.markers.empty()) identify.markers = stem + ".markers.yaml";
  std::string misuse;
  articam::models::visit_model(
      model, [&]<class Model>() { misuse = why_wrong(identify, articam::identify::Object::of<Model>()); });
  if (!misuse.empty()) {
    fail(misuse);
    return 2;
  }

  const auto run = [&model](auto&& job) { return run_for(model, job); };
  if (recording_option->count() > 0) {
    recording.output = options.output;
    recording.identify = identify;
    return run([&]<class Model>() { return articam::app::replay_recording<Model>(recording); });
  }

  articam::modelgen::Diagnostics diagnostics;
  const auto camera = articam::modelgen::read_camera(camera_file, diagnostics);
  fmt::print(stderr, "{}", diagnostics.text());
  if (!camera) return 1;
  options.camera = *camera;
  options.files = all_frames(sources, repeat);
  if (options.files.empty()) return fail(fmt::format("no PGM frame found in {}", fmt::join(sources, " ")));
  if (max_frames > 0 && options.files.size() > max_frames) options.files.resize(max_frames);
  options.show_progress = ::isatty(STDERR_FILENO) != 0;

  return run([&]<class Model>() { return articam::app::replay<Model>(options); });
}
