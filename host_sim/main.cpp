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
#include "host_sim/loop/closed_loop.hpp"
#include "host_sim/progress_bar.hpp"
#include "host_sim/report/control_csv.hpp"
#include "host_sim/report/pull_metrics.hpp"
#include "host_sim/report/run_folder.hpp"
#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string scenario;
  std::string mode{"default"};
  std::string out, frames_out;
  double duration_s{};  ///< 0: the scenario's own
  bool features{}, compare{};
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
template <class Tracker>
struct Links {
  using TimedTracker = hal::TimedTracker<Tracker, hal::MonotonicClock>;

  hal::FileLink<typename Tracker::EstimateType> file;
  RecordingLink<Tracker> memory;
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
  const std::string picture = picture_of<typename Scenario::Model>(middle, renderer);
  const std::string problem = write_report(out, run, metrics, picture, middle.t_s, write_whole);
  if (!problem.empty()) return fail(problem);
  fmt::print("{}  report              {}\n", summary(run, metrics), (out / "report.html").string());
  return std::fflush(stdout) == 0 ? 0 : fail(fmt::format("standard output: {}", std::strerror(errno)));
}

constexpr double kRate_hz = 30;

/// The object moves as at() says; no robot.
template <class Scenario>
int simulate(const Arguments& arguments) {
  using Model = typename Scenario::Model;
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
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
  Links<Tracker> links{{}, {*tracker, &Scenario::at, run}, timed_tracker, run};
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

constexpr std::pair<std::string_view, Feedback> kFeedbacks[]{
    {"default", Feedback::standard}, {"paper", Feedback::paper}, {"svd", Feedback::svd}, {"truth", Feedback::truth}};

template <class Scenario>
LoopOptions loop_options(const Arguments& arguments, Feedback feedback) {
  LoopOptions options;
  options.feedback = feedback;
  options.rendered = !arguments.features;
  options.duration_s = arguments.duration_s > 0 ? arguments.duration_s : Scenario::kDuration_s;
  options.rate_hz = kRate_hz;
  options.rendering = arguments.rendering;
  return options;
}

/// The table of what each feedback was worth, as it grows.
template <class Scenario>
int compare(const Arguments& arguments) {
  using Tracker = tracker::Tracker<typename Scenario::Model, DefaultScalar>;
  const Pull pull = Scenario::pull();
  std::string table = pull_table_head();
  fmt::print("{}", table);
  for (const auto& [name, feedback] : kFeedbacks) {
    ClosedLoop<Scenario, Tracker> loop{loop_options<Scenario>(arguments, feedback), {}};
    const ClosedLoopRun run = loop.run();
    if (!run.problem.empty()) return fail(run.problem);
    const auto metrics = evaluate_pull(run.samples, pull.commands, pull.settled, pull.control.period_s);
    const std::string row = pull_table_row(name, metrics);
    fmt::print("{}", row);
    std::fflush(stdout);
    table += row;
  }
  const std::string problem = write_whole(fs::path{arguments.out} / "feedback.txt", table);
  return problem.empty() ? 0 : fail(problem);
}

/// A robot moves the object, and goes by what the loop gives out.
template <class Scenario>
int manipulate(const Arguments& arguments) {
  if (arguments.compare) return compare<Scenario>(arguments);
  using Tracker = tracker::Tracker<typename Scenario::Model, DefaultScalar>;
  Feedback feedback{};
  for (const auto& [name, named] : kFeedbacks) {
    if (name == arguments.mode) feedback = named;
  }
  const LoopOptions options = loop_options<Scenario>(arguments, feedback);
  hal::FileLink<typename Tracker::EstimateType> file;
  if (file.open((fs::path{arguments.out} / "estimates.csv").string()) != Status::ok) return fail(file.problem());
  ProgressBar bar{static_cast<std::size_t>(options.duration_s * options.rate_hz)};
  ClosedLoop<Scenario, Tracker> loop{options,
                                     {.keep = keep_in(arguments.frames_out),
                                      .estimate = [&file](const auto& estimate) { return file.publish(estimate); },
                                      .progress = [&bar](std::size_t frames) { bar.show(frames); }}};
  const ClosedLoopRun run = loop.run();
  if (!run.problem.empty()) return fail(file.problem().empty() ? run.problem : file.problem());
  if (file.close() != Status::ok) return fail(file.problem());

  const fs::path out{arguments.out};
  const Pull pull = Scenario::pull();
  const auto metrics = evaluate_pull(run.samples, pull.commands, pull.settled, pull.control.period_s);
  if (const std::string problem = write_whole(out / "control.csv", control_csv(run.samples)); !problem.empty()) {
    return fail(problem);
  }
  const double middle_s = run.record.frames[run.record.frames.size() / 2].t_s;
  const int code = report<Scenario>(run.record, loop.renderer(middle_s), out);
  if (metrics.commands > 0) fmt::print("{}{}", pull_table_head(), pull_table_row(arguments.mode, metrics));
  return code;
}

struct Entry {
  std::string_view name, summary;
  int (*simulate)(const Arguments&);
  bool with_robot;
};
constexpr Entry kScenarios[]{
    {"drawer", "the same printer without a robot: its drawer opens and closes at up to 50 mm/s",
     &simulate<PaperScenario>, false},
    {PaperScenario::kName, PaperScenario::kSummary, &manipulate<PaperScenario>, true},
};
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
    if (entry.name != arguments.scenario) continue;
    const bool robot_wanted =
        arguments.features || arguments.compare || arguments.mode == "svd" || arguments.mode == "truth";
    if (robot_wanted && !entry.with_robot) {
      fmt::print(stderr, "articam-sim: {} has no robot: --level, --compare and these modes are of the others\n",
                 entry.name);
      return 2;
    }
    return entry.simulate(arguments);
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
  app.add_option(
         "--mode", arguments.mode,
         "of the tracker: default iterates inside a frame, paper takes one step a frame; with a robot also what it\n"
         "goes by instead: svd, the baseline of equation (7), or truth")
      ->check(CLI::IsMember({"default", "paper", "svd", "truth"}))
      ->capture_default_str();
  std::string level{"rendered"};
  app.add_option("--level", level,
                 "rendered: camera images; features: true edges with a detector's noise, without images")
      ->check(CLI::IsMember({"rendered", "features"}))
      ->capture_default_str();
  app.add_flag("--compare", arguments.compare,
               "run every mode and print how well the robot did by each (feedback.txt)");
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
  arguments.features = level == "features";
  return list ? sim::list_scenarios() : sim::run(arguments);
}
