#pragma once
/// @file  A camera behind the seam of hal/libcamera that does what a test says.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "hal/capture/luma_layout.hpp"
#include "hal/libcamera/capture_device.hpp"
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
  std::atomic<bool> refuses_buffers{false};
  std::atomic<std::thread::id> queuer{};  ///< who gave the last buffer back
  int being_read{-1}, reads{};            ///< as begin_reading and end_reading say
  int closes{};

  std::vector<std::string> cameras() override { return plugged_in ? ids : std::vector<std::string>{}; }
  hal::Abilities open(const std::string& id) override { return opened = id, abilities; }

  hal::Stream configure(std::uint32_t format, int width_px, int height_px, int buffers) override {
    const auto wide = static_cast<std::size_t>(width_px) * 4 + 32;  // room for any layout, and padding
    memory.assign(static_cast<std::size_t>(buffers), std::vector<std::uint8_t>(wide * std::size_t(height_px), 100));
    queued_.reserve(memory.size());
    hal::Stream stream{format, width_px, height_px, wide, {}};
    for (const auto& bytes : memory) stream.buffers.emplace_back(bytes);
    bend_stream(stream);
    bytes_used = memory[0].size();
    return stream;
  }

  void start(const hal::Controls& wanted, hal::CaptureEvents& events) override {
    controls = wanted;
    events_ = &events;
    for (int i = 0; i < static_cast<int>(memory.size()); ++i) queued_.push_back(i);
    on_start();
  }

  void begin_reading(int buffer) noexcept override {
    being_read = being_read == -1 ? buffer : -2;
    ++reads;
  }
  void end_reading(int buffer) noexcept override { being_read = being_read == buffer ? -1 : -2; }

  bool queue(int buffer) noexcept override {
    const std::lock_guard lock{mutex_};
    if (refuses_buffers || std::ranges::count(queued_, buffer) != 0) return false;
    queued_.push_back(buffer);
    queuer = std::this_thread::get_id();
    changed_.notify_all();
    return true;
  }

  /// Whether the camera comes to have so many buffers to write into.
  bool has_free(std::size_t num_buffers) {
    std::unique_lock lock{mutex_};
    return changed_.wait_for(lock, std::chrono::seconds{10}, [&] { return queued_.size() == num_buffers; });
  }

  void close() noexcept override {
    ++closes;
    for (const int buffer : std::exchange(queued_, {})) {  // as libcamera does on stop
      events_->completed({.buffer = buffer, .health = hal::CompletedBuffer::Health::cancelled});
    }
    events_ = nullptr;
  }

  /// The next free buffer as it comes back; false when the camera is given none to write into.
  bool complete(std::uint32_t sequence, const std::function<void(hal::CompletedBuffer&)>& bend = {}) {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, std::chrono::seconds{10}, [&] { return !queued_.empty(); })) return false;
    const int i = queued_.front();
    queued_.erase(queued_.begin());
    lock.unlock();
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
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<int> queued_;  ///< the buffers that the camera may write into; calls no heap after configure
};

}  // namespace articam::test
