#pragma once
/// @file  One replay: frames in, estimates.csv, overlays and a summary out.

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/config.hpp"
#include "hal/firmware.hpp"
#include "hal/link/file_link.hpp"
#include "hal/link/tee_link.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/replay/overlay.hpp"
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
  bool show_progress{};
};

/// Numbers separated by white space, in any locale; nothing where the text holds anything else.
std::optional<std::vector<double>> parse_numbers(const std::string& text);

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

/// The tracker's view of a frame, for the picture.
template <class Model, class S>
hal::Overlay overlay_of(const tracker::Tracker<Model, S>& tracker, const tracker::Estimate<Model, S>& estimate) {
  hal::Overlay overlay;
  overlay.seen.assign(tracker.detections().begin(), tracker.detections().end());
  const auto features = tracker::predict_features<Model, S>(estimate.q, tracker.camera());
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!features[i].visible) continue;
    overlay.predicted.push_back({std::string(Model::kMarkers[i].name), static_cast<double>(features[i].pixel.x()),
                                 static_cast<double>(features[i].pixel.y()), static_cast<double>(features[i].radius_px),
                                 tracker.matches()[i].matched});
  }
  overlay.caption = fmt::format("frame {}   {} {}   matched {}   rms {:.2f} px", estimate.frame, name(estimate.status),
                                name(estimate.reason), estimate.matched, static_cast<double>(estimate.rms_px));
  return overlay;
}

/// Sets the start of a tracker from the text of --q0. Returns what is wrong with it, or nothing.
template <class Model, class S>
std::string set_start(tracker::Tracker<Model, S>& tracker, const std::string& text) {
  constexpr std::size_t kNumbers = 7 + Model::kJoints.size();
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != kNumbers) {
    return fmt::format("--q0 '{}': expected {} numbers: px py pz qw qx qy qz and {} joint value(s)", text, kNumbers,
                       Model::kJoints.size());
  }
  std::array<double, kNumbers> fixed{};
  std::copy(numbers->begin(), numbers->end(), fixed.begin());
  const auto q0 = model::from_numbers<Model, S>(fixed);
  if (!q0.ok()) return fmt::format("--q0 '{}': the quaternion qw qx qy qz is zero, or a number is not finite", text);
  tracker.set_start(q0.value());
  return {};
}

/// Runs the firmware's loop over the files. Returns what went wrong, or nothing.
template <class Model>
std::string replay(const ReplayOptions& options) {
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  using Estimate = typename Tracker::EstimateType;
  Tracker tracker{options.camera, {.mode = options.mode}};
  if (!options.q0.empty()) {
    if (const auto problem = set_start(tracker, options.q0); !problem.empty()) return problem;
  }
  if (!options.overlay_folder.empty()) {
    std::error_code error;
    std::filesystem::create_directories(options.overlay_folder, error);
    if (error) return options.overlay_folder + ": " + error.message();
  }

  hal::PgmCamera camera{options.files, options.rate_hz};
  hal::ManualClock clock;
  const hal::MonotonicClock stopwatch;
  hal::TimedTracker<Tracker, hal::MonotonicClock> timed{tracker, stopwatch};
  hal::FileLink<Estimate> file;
  if (file.open(options.output) != Status::ok) return file.whole_file().problem();
  hal::TeeLink<Estimate, hal::FileLink<Estimate>> link{file};
  hal::RunLoop loop{camera, clock, link, timed, std::chrono::milliseconds{0}};

  Summary summary;
  for (std::size_t frame = 0; frame < options.files.size(); ++frame) {
    clock.set(camera.t_exposure(frame));
    const hal::Tick tick = loop.run_once();
    if (loop.counters().link_errors > 0) return file.whole_file().problem();
    if (tick == hal::Tick::failed) return camera.problem();
    const Estimate& estimate = link.latest();
    if (estimate.reason == tracker::Reason::image_mismatch) {
      return fmt::format("{}: is {} x {} pixels, but the camera file says {} x {}", options.files[frame].string(),
                         camera.image().width_px, camera.image().height_px, options.camera.width_px,
                         options.camera.height_px);
    }
    summary.add(estimate.status, static_cast<double>(estimate.rms_px), estimate.matched, timed.step_s(),
                std::vector<double>(estimate.q.joints.data(), estimate.q.joints.data() + estimate.q.joints.size()));
    if (!options.overlay_folder.empty()) {
      const auto picture = std::filesystem::path(options.overlay_folder) / fmt::format("overlay_{:05}.png", frame);
      std::string why;
      if (hal::write_overlay(picture, camera.image().view(), overlay_of(tracker, estimate), why) != Status::ok)
        return why;
    }
    if (options.show_progress) show_progress(frame + 1, options.files.size());
  }
  if (file.close() != Status::ok) return file.whole_file().problem();

  std::vector<std::string> joint_names;
  for (const auto& joint : Model::kJoints) joint_names.emplace_back(joint.name);
  fmt::print("{}", summary.text(joint_names, options.rate_hz));
  return {};
}

}  // namespace articam::app
