#pragma once
/// @file  A camera port over recorded frames, and with it the clock of the recording.

#include <array>
#include <string_view>

#include "hal/ports/camera_port.hpp"
#include "hal/ports/clock_port.hpp"

namespace articam::hal {

/// Frame k of the recording FOLDER is the file FOLDER/frame_00000k.pgm, as articam-sim writes them: binary PGM, maximum
/// 255, of at most the largest size of config.hpp, without comments. It stands for a sensor whose DMA fills a buffer:
/// a real driver keeps the interface and replaces read().
class SemihostingCamera {
 public:
  /// The folder's name must outlive the camera.
  SemihostingCamera(std::string_view folder, double rate_hz) noexcept : folder_{folder}, rate_hz_{rate_hz} {}

  Status start() noexcept { return Status::ok; }
  void stop() noexcept { next_ = 0; }
  /// end_of_stream after the last file; io_error for a file that is not such an image, which is passed over.
  Status acquire(Frame& out, std::chrono::milliseconds wait) noexcept;
  void release(Frame& frame) noexcept { frame = {}; }

  /// The exposure time of the newest frame.
  Timestamp now() const noexcept { return now_; }

 private:
  Status read(std::string_view path, ImageView& out) noexcept;

  std::string_view folder_;
  double rate_hz_;
  std::uint32_t next_{};
  Timestamp now_{};
  std::array<std::uint8_t, std::size_t{kMaxImageWidth_px} * kMaxImageHeight_px> pixels_{};
};
static_assert(CameraPort<SemihostingCamera> && ClockPort<SemihostingCamera>);

}  // namespace articam::hal
