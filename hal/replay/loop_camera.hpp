#pragma once
/// @file  Recorded frames as a camera that never ends, paced like a real one.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hal/ports/camera_port.hpp"
#include "hal/replay/pgm.hpp"

namespace articam::hal {

/// Frame k of the endless sequence is exposed at start + k / rate on the monotonic clock, as PgmCamera counts it, so
/// that both give a tracker the same spans of time. It waits for its instant and is never skipped: a loop that is late
/// gets late frames. All files are held in memory; after start() nothing is read and nothing allocates.
class LoopCamera {
 public:
  struct Options {
    std::vector<std::filesystem::path> files;
    double rate_hz{30};
    int width_px{}, height_px{};  ///< what every file must have
  };
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 30;  ///< of all frames together

  explicit LoopCamera(Options options) : options_{std::move(options)} {}

  /// Errors  no_device (no file), io_error and bad_argument (a file that cannot be taken): see problem().
  Status start() noexcept;
  void stop() noexcept { running_ = false; }
  Status acquire(Frame& out, std::chrono::milliseconds wait) noexcept;
  void release(Frame& frame) noexcept { frame = {}; }

  const std::string& problem() const noexcept { return problem_; }

 private:
  using Clock = std::chrono::steady_clock;  // CLOCK_MONOTONIC

  Status load();

  Options options_;
  std::vector<GreyImage> frames_;
  std::uint64_t next_{};
  bool running_{false};
  Clock::time_point begin_{};
  std::string problem_;
};
static_assert(CameraPort<LoopCamera>);

}  // namespace articam::hal
