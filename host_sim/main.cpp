/// @file  articam-sim: the synthetic world around the firmware's loop.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/firmware.hpp"
#include "hal/link/file_link.hpp"
#include "hal/link/whole_file.hpp"
#include "hal/replay/pgm.hpp"
#include "host_sim/loop/simulated_loop.hpp"
#include "host_sim/progress_bar.hpp"
#include "host_sim/report/control_csv.hpp"
#include "host_sim/report/pull_metrics.hpp"
#include "host_sim/report/run_folder.hpp"
#include "host_sim/report/take_pictures.hpp"
#include "host_sim/scenarios/cabinet.hpp"
#include "host_sim/scenarios/door.hpp"
#include "host_sim/scenarios/faults.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "host_sim/scenarios/valve.hpp"

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

/// Writes each frame as a file, where a folder is given.
KeepingCamera<SimCamera>::Keep keep_in(const fs::path& folder) {
  if (folder.empty()) return {};
  return [folder](const hal::Frame& frame, std::string& problem) {
    return hal::write_pgm(folder / fmt::format("frame_{:06}.pgm", frame.sequence), frame.pixels, problem);
  };
}

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

int write_all(const Report& report, const fs::path& out) {
  const Metrics metrics = evaluate(report.run);
  std::error_code error;
  fs::create_directories(out / "figures", error);
  if (error) return fail(fmt::format("{}: cannot be created: {}", (out / "figures").string(), error.message()));
  const std::string problem = write_report(out, report, metrics, write_whole);
  if (!problem.empty()) return fail(problem);
  fmt::print("{}  report              {}\n", summary(report.run, metrics), (out / "report.html").string());
  return std::fflush(stdout) == 0 ? 0 : fail(fmt::format("standard output: {}", std::strerror(errno)));
}

constexpr std::pair<std::string_view, Feedback> kFeedbacks[]{
    {"default", Feedback::standard}, {"paper", Feedback::paper}, {"svd", Feedback::svd}, {"truth", Feedback::truth}};

template <class Model>
LoopOptions loop_options(const Scenario<Model>& scenario, const Arguments& arguments, Feedback feedback) {
  LoopOptions options;
  options.feedback = feedback;
  options.rendered = !arguments.features;
  options.duration_s = arguments.duration_s > 0 ? arguments.duration_s : scenario.duration_s;
  options.rendering = arguments.rendering;
  return options;
}

template <class Model>
PullMetrics evaluate_pull(const Scenario<Model>& scenario, const LoopRun& run) {
  const Pull& pull = *scenario.pull;
  return sim::evaluate_pull(run.samples, pull.commands, pull.settled, pull.control.period_s);
}

bool knows_svd(const FrameRecord& frame) { return frame.svd.has_value(); }

/// What the robot did by this feedback; no samples where it knows no such joint.
template <class Model>
FeedbackRun pulled_by(std::string_view feedback, const Scenario<Model>& scenario, LoopRun&& run) {
  const bool blind = feedback == "svd" && std::ranges::none_of(run.record.frames, &knows_svd);
  FeedbackRun pulled{std::string{feedback}, evaluate_pull(scenario, run), std::move(run.samples)};
  if (blind) pulled.samples.clear();
  return pulled;
}

/// The same by every other feedback. Returns what went wrong, or nothing.
template <class Model>
std::string compare(const Scenario<Model>& scenario, const Arguments& arguments, std::vector<FeedbackRun>& feedbacks) {
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  for (const auto& [name, feedback] : kFeedbacks) {
    if (name == arguments.mode) continue;
    LoopRun run = SimulatedLoop<Tracker>{scenario, loop_options(scenario, arguments, feedback), {}}.run();
    if (!run.problem.empty()) return run.problem;
    feedbacks.push_back(pulled_by(name, scenario, std::move(run)));
  }
  return {};
}

/// How many estimates said what; all that is kept of a soak.
int tell_soak(const LoopRun& run) {
  fmt::print("{} frames\n", run.counters.frames);
  for (std::size_t i = 0; i < run.by_status.size(); ++i) {
    fmt::print("  {:<13} {}\n", tracker::name(static_cast<tracker::TrackingStatus>(i)), run.by_status[i]);
  }
  return 0;
}

template <class Model>
int simulate(const Scenario<Model>& scenario, const Arguments& arguments) {
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  Feedback feedback{};
  for (const auto& [name, named] : kFeedbacks) {
    if (name == arguments.mode) feedback = named;
  }
  LoopOptions options = loop_options(scenario, arguments, feedback);
  options.with_rival = !scenario.for_soaking;
  const fs::path out{arguments.out};
  hal::FileLink<typename Tracker::EstimateType> file;
  LoopObservers<typename Tracker::EstimateType> observers;
  observers.keep = keep_in(arguments.frames_out);
  ProgressBar bar{static_cast<std::size_t>(options.duration_s * options.rate_hz)};
  observers.progress = [&bar](std::size_t frames) { bar.show(frames); };
  if (!scenario.for_soaking) {
    if (file.open((out / "estimates.csv").string()) != Status::ok) return fail(file.problem());
    observers.estimate = [&file](const auto& estimate) { return file.publish(estimate); };
  }
  SimulatedLoop<Tracker> loop{scenario, options, std::move(observers)};
  LoopRun run = loop.run();
  if (!run.problem.empty()) return fail(file.problem().empty() ? run.problem : file.problem());
  if (scenario.for_soaking) return tell_soak(run);
  if (file.close() != Status::ok) return fail(file.problem());
  const RunRecord record = std::move(run.record);
  Report report{record, take_pictures<Model>(record, loop), {}};
  std::string table;
  if (scenario.pull) {
    std::string problem = write_whole(out / "control.csv", control_csv(run.samples));
    report.feedbacks.push_back(pulled_by(arguments.mode, scenario, std::move(run)));
    if (problem.empty() && arguments.compare) problem = compare(scenario, arguments, report.feedbacks);
    table = feedback_text(record, report.feedbacks);
    if (problem.empty() && arguments.compare) problem = write_whole(out / "feedback.txt", table);
    if (!problem.empty()) return fail(problem);
  }
  const int code = write_all(report, out);
  fmt::print("{}", table);
  return code;
}

struct Entry {
  std::string name, summary;
  std::function<int(const Arguments&)> simulate;
  bool with_robot;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> made;
    const auto add = [&made]<class Model>(const Scenario<Model>& scenario) {
      if constexpr (tracker::kIsInFirmware<Model>) {
        made.push_back({std::string{scenario.name}, std::string{scenario.summary},
                        [scenario](const Arguments& arguments) { return simulate(scenario, arguments); },
                        scenario.pull.has_value()});
      }
    };
    add(paper_scenario());
    add(drawer_scenario());
    add(soak_scenario());
    add(door_scenario());
    add(valve_scenario());
    add(cabinet_scenario());
    for (const auto& scenario : fault_scenarios()) add(scenario);
    return made;
  }();
  return all;
}

int list_scenarios() {
  for (const Entry& entry : entries()) fmt::print("{:<17} {}\n", entry.name, entry.summary);
  return 0;
}

/// Why these arguments do not go together; empty where they do.
std::string misuse(const Arguments& arguments, const Entry& entry) {
  const bool robot_wanted = arguments.compare || arguments.mode == "svd" || arguments.mode == "truth";
  if (robot_wanted && !entry.with_robot) {
    return entry.name + " has no robot: --compare, --mode svd and --mode truth are of the others";
  }
  if (arguments.features && !arguments.frames_out.empty()) {
    return "--level features makes no frames that --frames-out could keep";
  }
  return {};
}

int run(Arguments& arguments) {
  const auto entry = std::ranges::find(entries(), arguments.scenario, &Entry::name);
  if (const std::string why = misuse(arguments, *entry); !why.empty()) {
    fmt::print(stderr, "articam-sim: {}\n", why);
    return 2;
  }
  if (arguments.out.empty()) arguments.out = "out/" + arguments.scenario;
  for (const std::string& folder : {arguments.out, arguments.frames_out}) {
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) return fail(fmt::format("{}: cannot be created: {}", folder, error.message()));
  }
  return entry->simulate(arguments);
}

}  // namespace
}  // namespace articam::sim

int main(int argc, char** argv) {
  using namespace articam;
  sim::Arguments arguments;
  std::vector<std::string> names;
  for (const auto& entry : sim::entries()) names.emplace_back(entry.name);
  bool list = false;

  CLI::App app{
      "Renders a synthetic world, runs the firmware's loop on it, and compares its estimates with the truth.\n"
      "Writes truth.csv, estimates.csv, metrics.json and report.html. The same seed gives the same estimates.\n\n"
      "Example:  articam-sim paper --seed 3 --compare --out out/paper-3",
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
               "also run every other mode: how well the robot did by each, printed, in feedback.txt and in the report");
  app.add_option("--out", arguments.out, "folder for the results (default out/SCENARIO)");
  app.add_option("--frames-out", arguments.frames_out, "also keep every frame, as PGM, in this folder");
  app.add_option("--duration", arguments.duration_s, "simulated time, s (default: the scenario's)")
      ->check(CLI::Range(2.0, 1e6));
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
