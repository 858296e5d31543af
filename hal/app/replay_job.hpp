#pragma once
/// @file  One replay: frames in, estimates.csv, overlays and a summary out.

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/config.hpp"
#include "hal/app/identification.hpp"
#include "hal/app/start.hpp"
#include "hal/app/tracker_overlay.hpp"
#include "hal/firmware.hpp"
#include "hal/link/file_link.hpp"
#include "hal/link/tee_link.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/replay/pgm_camera.hpp"
#include "hal/run_loop.hpp"
#include "hal/timed_tracker.hpp"

namespace articam::app {

struct ReplayOptions {
  CameraParameters camera{};
  std::vector<std::filesystem::path> files;
  double rate_hz{30};
  std::string q0;  ///< empty: the model's own
  tracker::Mode mode{tracker::Mode::standard};
  std::string output, overlay_folder;
  identify::JobOptions identify;  ///< without outputs: nothing is to be identified
  bool show_progress{};
};

/// Returns what went wrong, or nothing; an empty path is nothing to do.
std::string create_folder(const std::string& path);

/// What the summary counts.
class Summary {
 public:
  void add(tracker::TrackingStatus status, double rms_px, int matched, double step_s, std::vector<double> joints);
  /// A few aligned lines for a person.
  std::string text(const std::vector<std::string>& joint_names, double rate_hz) const;

 private:
  std::vector<std::size_t> statuses_ = std::vector<std::size_t>(6);
  std::vector<double> rms_px_, step_s_;
  std::vector<std::vector<double>> joints_;  ///< of the frames with status tracking or degraded
};

void show_progress(std::size_t done, std::size_t all);

/// Slow recordings are integrated as well: a few of their frames may be missing.
inline tracker::Options tracker_options(const ReplayOptions& options) {
  tracker::Options tracker_options{.mode = options.mode};
  tracker_options.max_gap_s = std::max(tracker_options.max_gap_s, 3 / options.rate_hz);
  return tracker_options;
}

/// The firmware's loop over the files of one replay.
template <class Model>
class Replay {
 public:
  Replay(const ReplayOptions& options, Sightings& sightings) : options_{options}, sightings_{sightings} {}

  /// All of it. Returns what went wrong, or nothing.
  std::string run() {
    if (!options_.q0.empty()) {
      if (const auto problem = set_start(tracker_, parse_numbers(options_.q0), options_.q0); !problem.empty())
        return problem;
    }
    if (const auto problem = create_folder(options_.overlay_folder); !problem.empty()) return problem;
    if (file_.open(options_.output) != Status::ok) return file_.problem();
    const std::size_t num_frames = options_.files.size();
    for (std::size_t frame = 0; frame < num_frames; ++frame) {
      if (const auto problem = play(frame); !problem.empty()) return problem;
      if (options_.show_progress) show_progress(frame + 1, num_frames);
    }
    return file_.close() == Status::ok ? std::string{} : file_.problem();
  }

  std::string summary() const {
    std::vector<std::string> joint_names;
    for (const auto& joint : model::kValueRows<Model>) joint_names.emplace_back(joint.name);
    return summary_.text(joint_names, options_.rate_hz);
  }

 private:
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  using Estimate = typename Tracker::EstimateType;
  using Timed = hal::TimedTracker<Tracker, hal::MonotonicClock>;
  using Link = hal::TeeLink<Estimate, hal::FileLink<Estimate>>;

  std::string play(std::size_t frame) {
    clock_.set(camera_.t_exposure(frame));
    const hal::Tick tick = loop_.run_once();
    if (loop_.counters().link_errors > 0) return file_.problem();
    if (tick == hal::Tick::failed) return camera_.problem();
    const Estimate& estimate = link_.latest();
    if (estimate.reason == tracker::Reason::image_mismatch) {
      return fmt::format("{}: is {} x {} pixels, but the camera file says {} x {}", options_.files[frame].string(),
                         camera_.image().width_px, camera_.image().height_px, options_.camera.width_px,
                         options_.camera.height_px);
    }
    if (!options_.identify.outputs.empty()) note_sightings(tracker_, estimate, sightings_.recording);
    summary_.add(estimate.status, static_cast<double>(estimate.rms_px), estimate.matched, timed_.step_s(),
                 std::vector<double>(estimate.q.joints.data(), estimate.q.joints.data() + estimate.q.joints.size()));
    return draw(frame, estimate);
  }

  std::string draw(std::size_t frame, const Estimate& estimate) {
    if (options_.overlay_folder.empty()) return {};
    const auto picture = std::filesystem::path(options_.overlay_folder) / fmt::format("overlay_{:05}.png", frame);
    std::string why;
    (void)hal::write_overlay(picture, camera_.image().view(), overlay_of(tracker_, estimate), why);  // empty when drawn
    return why;
  }

  const ReplayOptions& options_;
  Tracker tracker_{options_.camera, tracker_options(options_)};
  hal::PgmCamera camera_{options_.files, options_.rate_hz};
  hal::ManualClock clock_;
  const hal::MonotonicClock stopwatch_{};
  Timed timed_{tracker_, stopwatch_};
  hal::FileLink<Estimate> file_;
  Link link_{file_};
  hal::RunLoop<hal::PgmCamera, hal::ManualClock, Link, Timed> loop_{
      camera_, clock_, link_, timed_, {.period = std::chrono::nanoseconds(from_seconds(1 / options_.rate_hz).ns)}};
  Summary summary_;
  Sightings& sightings_;
};

/// Runs the firmware's loop over the files, prints the summary, and identifies what was asked for. Returns what went
/// wrong, or nothing.
template <class Model>
std::string replay(const ReplayOptions& options) {
  return identify_from<Model>(options.identify, [&options](Sightings& sightings) {
    sightings.camera = options.camera;
    const auto job = std::make_unique<Replay<Model>>(options, sightings);  // large: it holds its detector's images
    if (auto problem = job->run(); !problem.empty()) return problem;
    return print(job->summary());
  });
}

}  // namespace articam::app
