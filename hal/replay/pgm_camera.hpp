#pragma once
/// @file  A camera that plays recorded frames.

#include <filesystem>
#include <string>
#include <vector>

#include "hal/ports/camera_port.hpp"
#include "hal/replay/pgm.hpp"

namespace articam::hal {

/// The PGM files that a user means, sorted by name: `what` is a folder (all its *.pgm), a file, or a glob pattern such
/// as 'run3/frame_*.pgm'. Empty when there is none.
std::vector<std::filesystem::path> find_frames(const std::string& what);

/// Plays files in the order given, frame k at time k / rate. Nothing waits: a replay is as fast as the tracker.
class PgmCamera {
 public:
  PgmCamera(std::vector<std::filesystem::path> files, double rate_hz);

  Status start() noexcept { return Status::ok; }
  void stop() noexcept {}
  /// Errors  end_of_stream after the last file; io_error or bad_argument for a file that cannot be taken (problem()
  ///         says why), and the next call goes on with the next file.
  Status acquire(Frame& out, std::chrono::milliseconds wait) noexcept;
  void release(Frame& frame) noexcept { frame = {}; }

  Timestamp t_exposure(std::size_t frame) const noexcept;
  const std::string& problem() const noexcept { return problem_; }
  const GreyImage& image() const noexcept { return image_; }  ///< the newest frame, valid until the next acquire

 private:
  std::vector<std::filesystem::path> files_;
  double rate_hz_;
  std::size_t next_{};
  GreyImage image_;
  std::string problem_;
};
static_assert(CameraPort<PgmCamera>);

}  // namespace articam::hal
