#pragma once
/// @file  The camera that the options name.

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "core/camera_parameters.hpp"
#include "hal/app/board/board_options.hpp"
#include "hal/capture/capture_counts.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/replay/loop_camera.hpp"
#include "hal/replay/pgm_camera.hpp"
#include "hal/supervision/supervised_camera.hpp"
#include "hal/v4l2/v4l2_camera.hpp"
#ifdef ARTICAM_WITH_LIBCAMERA
#include "hal/libcamera/libcamera_camera.hpp"
#endif

namespace articam::app {

/// What to say when a camera does not start.
template <class Camera>
std::string why_no_camera(const BoardOptions& options, Status status, const Camera& camera) {
  const std::string why{camera.problem()};
  return fmt::format("the camera{}{} does not start: {}", options.device.empty() ? "" : " ", options.device,
                     why.empty() ? std::string{name(status)} : why);
}

inline std::chrono::microseconds frame_period(const BoardOptions& options) {
  return std::chrono::microseconds{static_cast<std::int64_t>(1e6 / options.rate_hz + 0.5)};
}

inline std::optional<std::chrono::microseconds> exposure_of(const BoardOptions& options) {
  if (!options.exposure_us) return std::nullopt;
  return std::chrono::microseconds{static_cast<std::int64_t>(*options.exposure_us)};
}

/// Frames that the loop did not see.
inline void print_counts(const hal::CaptureCounts& counts) {
  fmt::print(stderr,
             "camera  frames overtaken {}  refused: starting up {}  corrupt {}  cancelled {}  wrong size {}  "
             "wrong stamp {}  out of order {}\n",
             counts.overtaken, counts.starting_up, counts.corrupt, counts.cancelled, counts.wrong_size,
             counts.wrong_stamp, counts.out_of_order);
}

/// Starts a real camera and keeps it alive while `job` runs with it.
template <class Camera, class Job>
std::string with_real_camera(const BoardOptions& options, Camera& camera, Job&& job) {
  const hal::MonotonicClock clock;
  hal::SupervisedCamera supervised{camera, clock, {.period = frame_period(options)}};
  if (const Status status = supervised.start(); status != Status::ok) return why_no_camera(options, status, camera);
  fmt::print(stderr, "camera  {}\n", camera.description());
  if (!camera.warning().empty()) fmt::print(stderr, "camera  warning: {}\n", camera.warning());
  const std::string problem = job(supervised);
  const auto [restarts, failed_attempts] = supervised.counts();
  if (!options.quiet && restarts + failed_attempts > 0) {
    fmt::print(stderr, "camera  started anew {} times, after {} attempts that failed\n", restarts, failed_attempts);
  }
  if (!options.quiet) print_counts(camera.counts());
  return problem;
}

/// Calls `job(camera)` with the camera of the options, started. Returns what went wrong, or nothing.
template <class Job>
std::string with_camera(const BoardOptions& options, const CameraParameters& parameters, Job&& job) {
  const int width_px = parameters.width_px, height_px = parameters.height_px;
  switch (options.source) {
    case BoardOptions::Source::replay: {
      hal::LoopCamera camera{{hal::find_frames(options.device), options.rate_hz, width_px, height_px}};
      const Status status = camera.start();
      return status == Status::ok ? job(camera) : why_no_camera(options, status, camera);
    }
    case BoardOptions::Source::v4l2: {
      hal::V4l2Options chosen{.device = options.device, .width_px = width_px, .height_px = height_px};
      chosen.period = frame_period(options);
      chosen.exposure = exposure_of(options);
      chosen.readout = std::chrono::microseconds{static_cast<std::int64_t>(1e6 * parameters.readout_time_s)};
      if (options.gain) chosen.gain = static_cast<int>(*options.gain);
      hal::V4l2Camera camera{chosen};
      return with_real_camera(options, camera, job);
    }
    case BoardOptions::Source::libcamera:
      break;
  }
#ifdef ARTICAM_WITH_LIBCAMERA
  hal::LibcameraOptions chosen{.camera = options.device, .width_px = width_px, .height_px = height_px};
  chosen.period = frame_period(options);
  chosen.exposure = exposure_of(options);
  chosen.gain = options.gain;
  chosen.stamp = options.stamp;
  hal::LibcameraCamera camera{chosen};
  return with_real_camera(options, camera, job);
#else
  return "the camera does not start: this program was built without libcamera; use --camera v4l2:DEV or replay:DIR";
#endif
}

}  // namespace articam::app
