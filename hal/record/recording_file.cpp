#include "hal/record/recording_file.hpp"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>

#include "hal/wire/crc32.hpp"

namespace articam::hal {
namespace {

using Bytes = std::span<const char>;

std::optional<std::vector<char>> read_file(const std::string& path, std::string& why) {
  std::ifstream stream{path, std::ios::binary};
  if (!stream) {
    why = path + ": " + std::strerror(errno);
    return std::nullopt;
  }
  return std::vector<char>{std::istreambuf_iterator<char>{stream}, {}};
}

template <class Plain>
bool take(Bytes bytes, std::size_t offset, Plain& out) {
  if (bytes.size() < offset || bytes.size() - offset < sizeof out) return false;
  std::memcpy(&out, bytes.data() + offset, sizeof out);
  return true;
}

std::uint32_t crc_of(Bytes bytes) {
  return wire::crc32({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

/// Takes one tick; its size, or 0 when there is no whole one.
std::size_t take_tick(Bytes bytes, RecordedTick& tick) {
  TickRecord& record = tick.record;
  if (!take(bytes, 0, record)) return 0;
  if (record.num_detections > kMaxDetections || record.num_times > record.times_ns.size() ||
      record.image_fault > tracker::Reason::blurred) {
    return 0;
  }
  const std::size_t size = sizeof(TickRecord) + record.num_detections * sizeof(vision::Detection);
  if (record.bytes != size || bytes.size() < size || crc_of(bytes.subspan(8, size - 8)) != record.crc32) return 0;
  for (std::size_t i = 0; i < record.num_detections; ++i) {
    vision::Detection detection;
    (void)take(bytes, sizeof(TickRecord) + i * sizeof detection, detection);
    (void)tick.detections.push_back(detection);
  }
  return size;
}

}  // namespace

std::optional<Recording> read_recording(const std::string& path, std::string& why) {
  const auto file = read_file(path, why);
  if (!file) return std::nullopt;
  const Bytes bytes{*file};
  Recording recording;
  const RecordingHeader& header = recording.header;
  if (!take(bytes, 0, recording.header) || header.magic != RecordingHeader::kMagic) {
    why = path + ": is no recording of articam-board";
    return std::nullopt;
  }
  if (header.header_bytes != sizeof(RecordingHeader) || header.schema != RecordingHeader{}.schema) {
    why = path + ": was recorded by another version; replay it with that one";
    return std::nullopt;
  }
  constexpr std::size_t kCovered = offsetof(RecordingHeader, crc32) + sizeof header.crc32;
  if (crc_of(bytes.subspan(kCovered, sizeof header - kCovered)) != header.crc32 ||
      header.num_start > kMaxRecordedStart || header.model_name.back() != 0) {
    why = path + ": its first bytes are damaged";
    return std::nullopt;
  }
  std::size_t offset = sizeof(RecordingHeader);
  for (;;) {
    RecordedTick tick;
    const std::size_t size = take_tick(bytes.subspan(offset), tick);
    if (size == 0 || tick.record.tick != recording.ticks.size()) break;
    recording.ticks.push_back(tick);
    offset += size;
  }
  std::uint32_t next = 0;
  recording.torn = take(bytes, offset, next) ? next != 0 : offset != bytes.size();
  return recording;
}

std::map<std::uint32_t, RecordedFrame> read_frames(const std::string& path, const RecordingHeader& recording,
                                                   std::string& why) {
  const auto file = read_file(path, why);
  if (!file) return {};
  const Bytes bytes{*file};
  FrameFileHeader header;
  constexpr std::size_t kCovered = offsetof(FrameFileHeader, crc32) + sizeof header.crc32;
  if (!take(bytes, 0, header) || header.magic != FrameFileHeader::kMagic ||
      crc_of(bytes.subspan(kCovered, sizeof header - kCovered)) != header.crc32 ||
      header.model_hash != recording.model_hash || header.width_px != recording.camera.width_px ||
      header.height_px != recording.camera.height_px) {
    why = path + ": holds no frames of this recording";
    return {};
  }
  std::map<std::uint32_t, RecordedFrame> frames;
  const auto pixels = static_cast<std::size_t>(header.width_px) * static_cast<std::size_t>(header.height_px);
  const std::size_t slot_bytes = sizeof(FrameSlot) + pixels;
  for (std::size_t i = 0; i < header.num_slots; ++i) {
    const std::size_t offset = sizeof header + i * slot_bytes;
    if (offset + slot_bytes > bytes.size()) break;
    FrameSlot slot;
    (void)take(bytes, offset, slot);
    if (slot.is_used == 0 || crc_of(bytes.subspan(offset + 4, slot_bytes - 4)) != slot.crc32) continue;
    const char* const begin = bytes.data() + offset + sizeof slot;
    frames[slot.tick] = {header.width_px, header.height_px, {begin, begin + pixels}};
  }
  return frames;
}

}  // namespace articam::hal
