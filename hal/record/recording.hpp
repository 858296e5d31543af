#pragma once
/// @file  What a recording holds: everything that the loop was told by its ports, tick by tick.
///
/// With the same answers the loop gives the same estimates, bit for bit. The structures are written as they lie in
/// memory, so a recording is read by the version that wrote it, on any machine of the same byte order: reproducing bits
/// takes the same code anyway.
///
///     RecordingHeader | TickRecord, its detections | TickRecord, its detections | ... | zeros

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "core/camera_parameters.hpp"
#include "core/status.hpp"
#include "core/tracker/options.hpp"
#include "core/tracker/tracking_status.hpp"
#include "core/vision/detection.hpp"

namespace articam::hal {

inline constexpr std::size_t kMaxRecordedStart = 7 + 32;  ///< numbers of q0

struct RecordingHeader {
  static constexpr std::uint64_t kMagic = 0x3130434552414341;  // "ACAREC01"

  std::uint64_t magic{kMagic};
  std::uint32_t header_bytes{sizeof(RecordingHeader)};
  std::uint32_t crc32{};         ///< of everything behind this field
  std::uint32_t schema{2};       ///< raised when a field of this file, a status or a reason changes its meaning
  std::uint32_t scalar_bytes{};  ///< of the tracker's numbers: 4 or 8
  std::uint64_t model_hash{};
  std::array<char, 64> model_name{};  ///< ends with a zero
  std::int64_t period_ns{};
  double max_age_s{};
  CameraParameters camera{};
  tracker::Options options{};
  std::uint64_t num_start{};  ///< numbers of `start`; 0 where the compiled-in q0 was used
  std::array<double, kMaxRecordedStart> start{};
};

/// One turn of RunLoop.
struct TickRecord {
  std::uint32_t bytes{};      ///< of the record and its detections; 0 behind the last one
  std::uint32_t crc32{};      ///< of everything behind this field, the detections included
  Status camera{};            ///< what acquire() returned
  std::uint8_t stepped{};     ///< the tracker was given the frame
  std::uint8_t mismatched{};  ///< and did not look at it: its size is not the camera file's
  std::uint8_t overloaded{};
  tracker::Reason image_fault{};  ///< what was wrong with the image itself
  std::uint8_t num_times{};       ///< answers of the clock
  std::uint8_t num_detections{};
  std::uint8_t unused{};
  std::uint32_t sequence{};
  std::uint32_t tick{};  ///< from 0
  std::int64_t t_exposure_ns{};
  std::array<std::int64_t, 2> times_ns{};
};

/// In the file of the last frames: each slot begins so, the pixels follow row by row without gaps.
struct FrameFileHeader {
  static constexpr std::uint64_t kMagic = 0x3130524652414341;  // "ACARFR01"

  std::uint64_t magic{kMagic};
  std::uint32_t crc32{};  ///< of everything behind this field
  std::uint32_t num_slots{};
  std::uint64_t model_hash{};
  std::int32_t width_px{}, height_px{};
};
struct FrameSlot {
  std::uint32_t crc32{};    ///< of everything behind this field, the pixels included
  std::uint32_t tick{};     ///< the one of the recording that was given this frame
  std::uint32_t is_used{};  ///< 0: never written
  std::uint32_t sequence{};
  std::int64_t t_exposure_ns{};
};

static_assert(std::endian::native == std::endian::little, "recordings are exchanged as they lie in memory");
static_assert(std::is_trivially_copyable_v<RecordingHeader> && std::is_trivially_copyable_v<vision::Detection>);
static_assert(sizeof(TickRecord) == 48 && sizeof(vision::Detection) == 60 && sizeof(FrameSlot) == 24);
static_assert(kMaxDetections <= 255, "num_detections is one byte");

inline constexpr std::size_t kMaxTickBytes = sizeof(TickRecord) + kMaxDetections * sizeof(vision::Detection);

}  // namespace articam::hal
