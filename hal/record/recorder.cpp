#include "hal/record/recorder.hpp"

#include <cstddef>
#include <cstring>

namespace articam::hal {
namespace {

template <class Plain>
void put(std::span<std::byte> block, std::size_t offset, const Plain& x) noexcept {
  std::memcpy(block.data() + offset, &x, sizeof x);
}

}  // namespace

Status Recorder::open_ticks(const std::string& path, std::uint64_t max_bytes, const RecordingHeader& header) noexcept {
  constexpr std::size_t kNumBlocks = 256;  // seconds of ticks, should the disk be slow
  static_assert(kMaxTickBytes >= sizeof(RecordingHeader));
  const Status status = ticks_.open({path, max_bytes, kMaxTickBytes, kNumBlocks});
  if (status != Status::ok) return status;
  put(ticks_.reserve(), 0, header);
  ticks_.commit(sizeof header, 0, offsetof(RecordingHeader, crc32));
  max_bytes_ = max_bytes;
  end_ = sizeof header;
  return Status::ok;
}

Status Recorder::open_frames(const std::string& path, std::uint32_t num_slots, const RecordingHeader& header) noexcept {
  constexpr std::size_t kNumBlocks = 8;
  const auto pixels =
      static_cast<std::size_t>(header.camera.width_px) * static_cast<std::size_t>(header.camera.height_px);
  const std::size_t block = sizeof(FrameSlot) + pixels;
  const Status status =
      frames_.open({path, sizeof(FrameFileHeader) + std::uint64_t{num_slots} * block, block, kNumBlocks});
  if (status != Status::ok) return status;
  put(frames_.reserve(), 0,
      FrameFileHeader{.num_slots = num_slots,
                      .model_hash = header.model_hash,
                      .width_px = header.camera.width_px,
                      .height_px = header.camera.height_px});
  frames_.commit(sizeof(FrameFileHeader), 0, offsetof(FrameFileHeader, crc32));
  num_slots_ = num_slots;
  return Status::ok;
}

Status Recorder::close() noexcept {
  finish_tick();
  const Status ticks = ticks_.close(end_);
  const Status frames = frames_.close();
  return ticks != Status::ok ? ticks : frames;
}

void Recorder::acquired(Status status, const Frame& frame) noexcept {
  finish_tick();
  record_ = {.camera = status, .sequence = frame.sequence, .tick = tick_++, .t_exposure_ns = frame.t_exposure.ns};
  in_tick_ = true;
  if (status == Status::ok) keep_frame(frame);
}

void Recorder::answered(Timestamp now) noexcept {
  if (in_tick_ && record_.num_times < record_.times_ns.size()) record_.times_ns[record_.num_times++] = now.ns;
}

void Recorder::stepped(const vision::Detections& detections, const tracker::ImageReport& image,
                       bool mismatched) noexcept {
  record_.stepped = 1;
  record_.overloaded = image.overloaded ? 1 : 0;
  record_.image_fault = image.fault;
  record_.mismatched = mismatched ? 1 : 0;
  detections_ = detections;
}

void Recorder::finish_tick() noexcept {
  if (!in_tick_) return;
  in_tick_ = false;
  if (!ticks_.is_open()) return;
  record_.num_detections = static_cast<std::uint8_t>(record_.stepped != 0 ? detections_.size() : 0);
  const std::size_t bytes = sizeof(TickRecord) + record_.num_detections * sizeof(vision::Detection);
  const std::span<std::byte> block = broken_ || end_ + bytes > max_bytes_ ? std::span<std::byte>{} : ticks_.reserve();
  if (block.empty()) {
    broken_ = true;
    ++counters_.ticks_missed;
    return;
  }
  record_.bytes = static_cast<std::uint32_t>(bytes);
  put(block, 0, record_);
  for (std::size_t i = 0; i < record_.num_detections; ++i) {
    put(block, sizeof(TickRecord) + i * sizeof(vision::Detection), detections_[i]);
  }
  ticks_.commit(bytes, end_, offsetof(TickRecord, crc32));
  end_ += bytes;
  ++counters_.ticks;
}

void Recorder::keep_frame(const Frame& frame) noexcept {
  if (!frames_.is_open() || !frame.pixels.ok()) return;
  const std::span<std::byte> block = frames_.reserve();
  const auto width = static_cast<std::size_t>(frame.pixels.width_px);
  const auto height = static_cast<std::size_t>(frame.pixels.height_px);
  if (block.size() != sizeof(FrameSlot) + width * height) {  // the writer is behind, or a frame of another size
    ++counters_.frames_missed;
    return;
  }
  put(block, 0,
      FrameSlot{.tick = record_.tick, .is_used = 1, .sequence = frame.sequence, .t_exposure_ns = frame.t_exposure.ns});
  for (std::size_t row = 0; row < height; ++row) {
    std::memcpy(block.data() + sizeof(FrameSlot) + row * width, frame.pixels.row(static_cast<int>(row)), width);
  }
  const std::uint64_t offset = sizeof(FrameFileHeader) + std::uint64_t{next_slot_} * block.size();
  frames_.commit(block.size(), offset, offsetof(FrameSlot, crc32));
  next_slot_ = (next_slot_ + 1) % num_slots_;
  ++counters_.frames;
}

}  // namespace articam::hal
