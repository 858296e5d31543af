#pragma once
/// @file  A camera behind the seam of hal/libcamera that does what a test says.

#include <algorithm>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "hal/libcamera/capture_device.hpp"
#include "hal/libcamera/luma_layout.hpp"
#include "hal/posix/monotonic_clock.hpp"

namespace articam::test {

class ScriptedDevice final : public hal::CaptureDevice {
 public:
  std::vector<std::string> ids{"front", "back"};
  std::atomic<bool> plugged_in{true};
  hal::Abilities abilities{{hal::fourcc("NV12")}, {}, {}, {}};
  std::function<void(hal::Stream&)> bend_stream = [](hal::Stream&) {};    ///< what differs from what was asked for
  std::function<void()> on_start = [this] { complete(first_sequence); };  ///< the first frame
  std::uint32_t first_sequence{};
  std::int64_t exposure_ns{};
  hal::Controls controls;
  std::string opened;
  std::vector<int> queued;  ///< the buffers that the camera may write into; calls no heap after configure
  bool refuses_buffers{false};
  int closes{};

  std::vector<std::string> cameras() override { return plugged_in ? ids : std::vector<std::string>{}; }
  hal::Abilities open(const std::string& id) override { return opened = id, abilities; }

  hal::Stream configure(std::uint32_t format, int width_px, int height_px, int buffers) override {
    const auto wide = static_cast<std::size_t>(width_px) * 4 + 32;  // room for any layout, and padding
    memory.assign(static_cast<std::size_t>(buffers), std::vector<std::uint8_t>(wide * std::size_t(height_px), 100));
    queued.reserve(memory.size());
    hal::Stream stream{format, width_px, height_px, wide, {}};
    for (const auto& bytes : memory) stream.buffers.emplace_back(bytes);
    bend_stream(stream);
    bytes_used = memory[0].size();
    return stream;
  }

  void start(const hal::Controls& wanted, hal::CaptureEvents& events) override {
    controls = wanted;
    events_ = &events;
    for (int i = 0; i < static_cast<int>(memory.size()); ++i) queued.push_back(i);
    on_start();
  }

  bool queue(int buffer) noexcept override {
    if (refuses_buffers || std::ranges::count(queued, buffer) != 0) return false;
    queued.push_back(buffer);
    return true;
  }

  void close() noexcept override {
    ++closes;
    for (const int buffer : std::exchange(queued, {})) {  // as libcamera does on stop
      events_->completed({.buffer = buffer, .health = hal::CompletedBuffer::Health::cancelled});
    }
    events_ = nullptr;
  }

  /// The next free buffer as it comes back; false when the camera has none to write into.
  bool complete(std::uint32_t sequence, const std::function<void(hal::CompletedBuffer&)>& bend = {}) {
    if (queued.empty()) return false;
    const int i = queued.front();
    queued.erase(queued.begin());
    hal::CompletedBuffer buffer{i, {}, sequence, hal::MonotonicClock{}.now(), exposure_ns, bytes_used};
    if (bend) bend(buffer);
    events_->completed(buffer);
    return true;
  }

  void unplug() {
    plugged_in = false;
    events_->disconnected();
  }

  std::vector<std::vector<std::uint8_t>> memory;
  std::size_t bytes_used{};

 private:
  hal::CaptureEvents* events_{};
};

}  // namespace articam::test
