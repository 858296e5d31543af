#pragma once
/// @file  Writes a recording while the loop runs.

#include <cstdint>
#include <string>

#include "core/timestamp.hpp"
#include "core/tracker/image_report.hpp"
#include "hal/ports/camera_port.hpp"
#include "hal/record/recording.hpp"
#include "hal/record/spooler.hpp"

namespace articam::hal {

/// Everything that one tick's ports have answered is gathered by their Recording... wrappers (recording_ports.hpp) and
/// goes out when the next tick begins. Where nothing was opened, nothing happens.
///
/// The file of ticks begins with the program and ends when it is full: a hole in it would be worth nothing, since each
/// estimate rests on those before. The file of frames is a ring: it holds the last ones.
class Recorder {
 public:
  struct Counters {
    std::uint64_t ticks{};         ///< in the recording
    std::uint64_t ticks_missed{};  ///< after it was full or its writer behind
    std::uint64_t frames{}, frames_missed{};
  };

  /// Errors of all three  io_error; problem() says why.
  Status open_ticks(const std::string& path, std::uint64_t max_bytes, const RecordingHeader& header) noexcept;
  Status open_frames(const std::string& path, std::uint32_t num_slots, const RecordingHeader& header) noexcept;
  Status close() noexcept;

  void acquired(Status status, const Frame& frame) noexcept;  ///< begins a tick
  void answered(Timestamp now) noexcept;
  void stepped(const vision::Detections& detections, const tracker::ImageReport& image, bool mismatched) noexcept;

  const Counters& counters() const noexcept { return counters_; }
  const std::string& problem() const noexcept {
    return ticks_.problem().empty() ? frames_.problem() : ticks_.problem();
  }

 private:
  void finish_tick() noexcept;
  void keep_frame(const Frame& frame) noexcept;

  Spooler ticks_, frames_;
  std::uint64_t max_bytes_{}, end_{};
  std::uint32_t num_slots_{}, next_slot_{};
  bool in_tick_{false}, broken_{false};
  std::uint32_t tick_{};
  TickRecord record_{};
  vision::Detections detections_{};
  Counters counters_{};
};

}  // namespace articam::hal
