/// @file  articam-sim: the synthetic world around the firmware's loop.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/firmware.hpp"
#include "hal/link/file_link.hpp"
#include "hal/link/whole_file.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/replay/pgm.hpp"
#include "hal/run_loop.hpp"
#include "hal/timed_tracker.hpp"
#include "host_sim/ports/recording_link.hpp"
#include "host_sim/ports/sim_camera.hpp"
#include "host_sim/progress_bar.hpp"
#include "host_sim/report/camera_picture.hpp"
#include "host_sim/report/report_html.hpp"
#include "host_sim/report/truth_csv.hpp"
#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string scenario;
  std::string mode{"default"};
  std::string out, frames_out;
  double duration_s{};  ///< 0: the scenario's own
  RenderOptions rendering;
};

/// The simulated camera; keeps each frame as a file where a folder is given.
class KeepingCamera {
 public:
  KeepingCamera(SimCamera& camera, std::string folder) : camera_{camera}, folder_{std::move(folder)} {}

  Status start() noexcept { return camera_.start(); }
  Status acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept {
    const Status status = camera_.acquire(out, wait);
    if (status != Status::ok || folder_.empty()) return status;
    return hal::write_pgm(fs::path{folder_} / fmt::format("frame_{:06}.pgm", out.sequence), out.pixels, problem_);
  }
  void release(hal::Frame& frame) noexcept { camera_.release(frame); }
  const std::string& problem() const noexcept { return problem_; }

 private:
  SimCamera& camera_;
  std::string folder_, problem_;
};

/// estimates.csv and the record of the report, from one loop.
template <class Scenario, class Tracker>
struct Links {
  using TimedTracker = hal::TimedTracker<Tracker, hal::MonotonicClock>;

  hal::FileLink<typename Tracker::EstimateType> file;
  RecordingLink<Scenario, Tracker> memory;
  const TimedTracker& tracker;
  RunRecord& run;

  Status publish(const typename Tracker::EstimateType& estimate) noexcept {
    const Status recorded = memory.publish(estimate);
    run.frames.back().step_s = tracker.step_s();
    return recorded == Status::ok ? file.publish(estimate) : recorded;
  }
};

int fail(const std::string& why) {
  fmt::print(stderr, "articam-sim: {}\n", why);
  return 1;
}

template <class Scenario>
RunRecord describe(const Arguments& arguments) {
  using Model = typename Scenario::Model;
  RunRecord run;
  run.scenario = Scenario::kName;
  run.mode = arguments.mode;
  run.seed = arguments.rendering.seed;
  run.noise_grey = arguments.rendering.noise_grey;
  run.blur_px = arguments.rendering.blur_px;
  run.rest_s = Scenario::kRest_s;
  run.degrees_of_freedom = model::kDof<Model>;
  for (const model::JointRow& joint : Model::kJoints) {
    run.joint_names.emplace_back(joint.name);
    run.joint_is_length.push_back(joint.kind == model::JointKind::prismatic);
  }
  return run;
}

void print_summary(const RunRecord& run, const Metrics& metrics, const fs::path& out) {
  const auto tracked = metrics.frames_by_status[static_cast<std::size_t>(tracker::TrackingStatus::tracking)];
  fmt::print("scenario {}, mode {}, seed {}\n", run.scenario, run.mode, run.seed);
  fmt::print("  frames tracked      {} of {}\n", tracked, run.frames.size());
  for (const JointMetrics& joint : metrics.joints) {
    fmt::print("  {:<19} RMS {:.3f} {}", joint.name, joint.rms, joint.is_length ? "mm" : "mrad");
    if (const auto& lag = joint.lag_ms) {
      fmt::print(", lag {:.2f} ms ({:.2f} to {:.2f})", lag->value, lag->low, lag->high);
    }
    fmt::print("\n");
  }
  fmt::print("  base                RMS {:.3f} mm, {:.3f} deg\n", metrics.position_rms_mm, metrics.orientation_rms_deg);
  if (const auto& rate = metrics.decay_rate_per_s) {
    fmt::print("  convergence         {:.2f} 1/s ({:.2f} to {:.2f})\n", rate->value, rate->low, rate->high);
  }
  fmt::print("  image to estimate   {:.2f} ms (median), {:.2f} ms (99 %)\n", metrics.step_median_ms,
             metrics.step_p99_ms);
  fmt::print("  report              {}\n", (out / "report.html").string());
}

Status write_whole(const fs::path& path, const std::string& content, std::string& problem) {
  hal::WholeFile file;
  Status status = file.open(path.string());
  if (status == Status::ok) status = file.write(content);
  if (status == Status::ok) status = file.close();
  problem = file.problem();
  return status;
}

/// A frame from the middle of the run, with what was estimated there.
template <class Scenario>
std::string picture(Renderer& renderer, const FrameRecord& frame) {
  using Model = typename Scenario::Model;
  std::vector<std::uint8_t> pixels;
  renderer.render(scene_markers<Model>(Scenario::at(frame.t_s).q), frame.frame, pixels);
  std::vector<SceneMarker> outlined;
  if (frame.estimate) {
    model::Configuration<Model, double> q;
    q.T_cam_obj = frame.estimate->T_cam_obj;
    for (int j = 0; j < model::kNumJoints<Model>; ++j) {
      q.joints[j] = frame.estimate->joints[static_cast<std::size_t>(j)];
    }
    outlined = scene_markers<Model>(q);
  }
  const CameraParameters& camera = renderer.camera();
  return camera_picture({pixels.data(), camera.width_px, camera.height_px, camera.width_px}, camera, outlined);
}

/// truth.csv and metrics.json first: they do not need gnuplot.
template <class Scenario>
int report(const RunRecord& run, Renderer& renderer, const fs::path& out) {
  const Metrics metrics = evaluate(run);
  std::string problem;
  if (write_whole(out / "truth.csv", truth_csv(run), problem) != Status::ok ||
      write_whole(out / "metrics.json", metrics_json(run, metrics), problem) != Status::ok) {
    return fail(problem);
  }
  std::error_code ignored;
  fs::remove(out / "report.html", ignored);  // without gnuplot, an old page must not stand beside new numbers
  std::vector<Figure> figures;
  if (draw_figures(run, figures) != Status::ok) {
    return fail(
        fmt::format("no report.html: the program gnuplot is missing or failed (Debian: apt-get install gnuplot-nox). "
                    "The CSV files and metrics.json in {} are complete.",
                    out.string()));
  }
  const FrameRecord& middle = run.frames[run.frames.size() / 2];
  const std::string page = report_html(run, metrics, picture<Scenario>(renderer, middle), middle.t_s, figures);
  if (write_whole(out / "report.html", page, problem) != Status::ok) return fail(problem);
  print_summary(run, metrics, out);
  return 0;
}

template <class Scenario>
int simulate(const Arguments& arguments) {
  using Model = typename Scenario::Model;
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  constexpr double kRate_hz = 30;
  constexpr std::chrono::milliseconds kWait{50};

  const double duration_s = arguments.duration_s > 0 ? arguments.duration_s : Scenario::kDuration_s;
  SimCamera::Options camera_options;
  camera_options.rate_hz = kRate_hz;
  camera_options.num_frames = static_cast<std::uint32_t>(duration_s * kRate_hz + 0.5);
  tracker::Options tracker_options;
  if (arguments.mode == "paper") tracker_options.mode = tracker::Mode::paper;

  RunRecord run = describe<Scenario>(arguments);
  run.frames.reserve(camera_options.num_frames);
  Renderer renderer{Scenario::camera(), arguments.rendering};
  SimClock clock;
  SimCamera sim_camera{renderer, [](double t_s) { return scene_markers<Model>(Scenario::at(t_s).q); }, clock,
                       camera_options};
  KeepingCamera camera{sim_camera, arguments.frames_out};
  const auto tracker = std::make_unique<Tracker>(Scenario::camera(), tracker_options);
  const hal::MonotonicClock host_clock;  // steps are measured in real time
  hal::TimedTracker timed_tracker{*tracker, host_clock};
  Links<Scenario, Tracker> links{{}, {*tracker, run}, timed_tracker, run};
  if (links.file.open((fs::path{arguments.out} / "estimates.csv").string()) != Status::ok) {
    return fail(links.file.whole_file().problem());
  }

  hal::RunLoop loop{camera, clock, links, timed_tracker, kWait};
  if (loop.start() != Status::ok) return fail("the simulated camera does not start");
  {
    ProgressBar bar{camera_options.num_frames};
    for (hal::Tick tick = loop.run_once(); tick != hal::Tick::ended; tick = loop.run_once()) {
      if (tick == hal::Tick::failed) {
        return fail(camera.problem().empty() ? links.file.whole_file().problem() : camera.problem());
      }
      bar.show(run.frames.size());
    }
  }
  if (links.file.close() != Status::ok) return fail(links.file.whole_file().problem());
  return report<Scenario>(run, renderer, arguments.out);
}

struct Entry {
  std::string_view name, summary;
  int (*simulate)(const Arguments&);
};
constexpr Entry kScenarios[]{{PaperScenario::kName, PaperScenario::kSummary, &simulate<PaperScenario>}};

int list_scenarios() {
  for (const Entry& entry : kScenarios) fmt::print("{:<12} {}\n", entry.name, entry.summary);
  return 0;
}

int run(Arguments& arguments) {
  if (arguments.out.empty()) arguments.out = "out/" + arguments.scenario;
  for (const std::string& folder : {arguments.out, arguments.frames_out}) {
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) return fail(fmt::format("{}: cannot be created: {}", folder, error.message()));
  }
  for (const Entry& entry : kScenarios) {
    if (entry.name == arguments.scenario) return entry.simulate(arguments);
  }
  return 2;  // not reached: the command line accepts only these names
}

}  // namespace
}  // namespace articam::sim

int main(int argc, char** argv) {
  using namespace articam;
  sim::Arguments arguments;
  std::vector<std::string> names;
  for (const auto& entry : sim::kScenarios) names.emplace_back(entry.name);
  bool list = false;

  CLI::App app{
      "Renders a synthetic world, runs the firmware's loop on it, and compares its estimates with the truth.\n"
      "Writes truth.csv, estimates.csv, metrics.json and report.html. The same seed gives the same estimates.\n\n"
      "Example:  articam-sim paper --seed 3 --mode paper --out out/paper-mode",
      "articam-sim"};
  app.set_version_flag("--version", ARTICAM_VERSION);
  auto* scenario =
      app.add_option("SCENARIO", arguments.scenario, "which world; see --list")->check(CLI::IsMember(names));
  app.add_flag("--list", list, "name the scenarios and stop");
  app.add_option("--seed", arguments.rendering.seed, "of the clutter and of the noise")->capture_default_str();
  app.add_option("--mode", arguments.mode,
                 "of the tracker: default iterates inside a frame, paper takes one step a frame")
      ->check(CLI::IsMember({"default", "paper"}))
      ->capture_default_str();
  app.add_option("--out", arguments.out, "folder for the results (default out/SCENARIO)");
  app.add_option("--frames-out", arguments.frames_out, "also keep every frame, as PGM, in this folder");
  app.add_option("--duration", arguments.duration_s, "simulated time, s (default: the scenario's)")
      ->check(CLI::Range(2.0, 3600.0));
  app.add_option("--noise", arguments.rendering.noise_grey, "sigma of the sensor's noise, grey levels")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--blur", arguments.rendering.blur_px, "sigma of the lens's blur, px")
      ->check(CLI::Range(0.0, 5.0))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    if (!list && scenario->empty()) throw CLI::RequiredError("SCENARIO (articam-sim --list names them)");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return list ? sim::list_scenarios() : sim::run(arguments);
}
