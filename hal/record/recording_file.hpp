#pragma once
/// @file  Reads what a recorder has written.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/vision/image_view.hpp"
#include "hal/record/recording.hpp"

namespace articam::hal {

struct RecordedTick {
  TickRecord record;
  vision::Detections detections;
};

struct Recording {
  RecordingHeader header;
  std::vector<RecordedTick> ticks;
  bool torn{};  ///< the power went: behind the last whole tick there is something else than the end
};

/// Nothing when the file is no recording of this version; `why` is then a sentence with the path.
std::optional<Recording> read_recording(const std::string& path, std::string& why);

/// The frames of a ring that are whole, by tick. Empty and `why` set when the file is none.
struct RecordedFrame {
  int width_px{}, height_px{};
  std::vector<std::uint8_t> pixels;
  ImageView view() const noexcept { return {pixels.data(), width_px, height_px, width_px}; }
};
std::map<std::uint32_t, RecordedFrame> read_frames(const std::string& path, const RecordingHeader& recording,
                                                   std::string& why);

}  // namespace articam::hal
