/// @file  articam-sim: the synthetic world around the firmware's loop.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/firmware.hpp"
#include "hal/link/file_link.hpp"
#include "hal/link/whole_file.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/replay/pgm.hpp"
#include "hal/run_loop.hpp"
#include "hal/timed_tracker.hpp"
#include "host_sim/ports/keeping_camera.hpp"
#include "host_sim/ports/recording_link.hpp"
#include "host_sim/ports/sim_camera.hpp"
#include "host_sim/progress_bar.hpp"
#include "host_sim/report/run_folder.hpp"
#include "host_sim/report/scenario_run.hpp"
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

using Camera = KeepingCamera<SimCamera>;
static_assert(hal::CameraPort<Camera>);

/// Writes each frame as a file, where a folder is given.
Camera::Keep keep_in(const fs::path& folder) {
  if (folder.empty()) return {};
  return [folder](const hal::Frame& frame, std::string& problem) {
    return hal::write_pgm(folder / fmt::format("frame_{:06}.pgm", frame.sequence), frame.pixels, problem);
  };
}

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

std::string write_whole(const fs::path& path, const std::string& content) {
  hal::WholeFile file;
  const bool written =
      file.open(path.string()) == Status::ok && file.write(content) == Status::ok && file.close() == Status::ok;
  return written ? std::string{} : file.problem();
}

template <class Scenario>
int report(const RunRecord& run, Renderer& renderer, const fs::path& out) {
  const Metrics metrics = evaluate(run);
  const FrameRecord& middle = run.frames[run.frames.size() / 2];
  const std::string picture = picture_of<Scenario>(middle, renderer);
  const std::string problem = write_report(out, run, metrics, picture, middle.t_s, write_whole);
  if (!problem.empty()) return fail(problem);
  fmt::print("{}  report              {}\n", summary(run, metrics), (out / "report.html").string());
  return std::fflush(stdout) == 0 ? 0 : fail(fmt::format("standard output: {}", std::strerror(errno)));
}

template <class Scenario>
int simulate(const Arguments& arguments) {
  using Model = typename Scenario::Model;
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  constexpr double kRate_hz = 30;
  constexpr hal::LoopTimes kTimes{.period = std::chrono::nanoseconds{33'333'333}};

  const double duration_s = arguments.duration_s > 0 ? arguments.duration_s : Scenario::kDuration_s;
  SimCamera::Options camera_options;
  camera_options.rate_hz = kRate_hz;
  camera_options.num_frames = static_cast<std::uint32_t>(duration_s * kRate_hz + 0.5);
  tracker::Options tracker_options;
  if (arguments.mode == "paper") tracker_options.mode = tracker::Mode::paper;

  RunRecord run = describe<Scenario>(arguments.mode, arguments.rendering);
  run.frames.reserve(camera_options.num_frames);
  Renderer renderer{Scenario::camera(), arguments.rendering};
  SimClock clock;
  SimCamera sim_camera{renderer, [](double t_s) { return scene_markers<Model>(Scenario::at(t_s).q); }, clock,
                       camera_options};
  Camera camera{sim_camera, keep_in(arguments.frames_out)};
  const auto tracker = std::make_unique<Tracker>(Scenario::camera(), tracker_options);
  const hal::MonotonicClock host_clock;  // steps are measured in real time
  hal::TimedTracker timed_tracker{*tracker, host_clock};
  Links<Scenario, Tracker> links{{}, {*tracker, run}, timed_tracker, run};
  if (links.file.open((fs::path{arguments.out} / "estimates.csv").string()) != Status::ok) {
    return fail(links.file.problem());
  }

  hal::RunLoop loop{camera, clock, links, timed_tracker, kTimes};
  if (loop.start() != Status::ok) return fail("the simulated camera does not start");
  {
    ProgressBar bar{camera_options.num_frames};
    for (hal::Tick tick = loop.run_once(); tick != hal::Tick::ended; tick = loop.run_once()) {
      if (tick == hal::Tick::failed) {
        return fail(camera.problem().empty() ? links.file.problem() : camera.problem());
      }
      bar.show(run.frames.size());
    }
  }
  if (links.file.close() != Status::ok) return fail(links.file.problem());
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
