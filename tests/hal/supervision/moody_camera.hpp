#pragma once
/// @file  A camera that breaks and recovers as a test says, and notices two threads that touch it at once.

#include <atomic>
#include <thread>

#include "hal/ports/camera_port.hpp"
#include "hal/posix/monotonic_clock.hpp"

namespace articam::test {

class MoodyCamera {
 public:
  enum class Mood { gives, silent, broken_frames, unplugged };
  std::atomic<Mood> mood{Mood::gives};
  std::atomic<int> starts{}, touched_at_once{}, leaked{};
  std::atomic<bool> starts_slowly{false};

  Status start() noexcept {
    const Touch touch{*this};
    ++starts;
    while (starts_slowly) std::this_thread::yield();
    if (mood == Mood::unplugged) return Status::no_device;
    capturing_ = true;
    sequence_ = 0;
    return Status::ok;
  }

  void stop() noexcept {
    const Touch touch{*this};
    leaked += lent_;
    lent_ = 0;
    capturing_ = false;
  }

  Status acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept {
    const Touch touch{*this};
    if (!capturing_ || mood == Mood::unplugged) return Status::no_device;
    if (mood == Mood::broken_frames) return Status::io_error;
    if (mood == Mood::silent) return std::this_thread::sleep_for(wait), Status::timeout;
    out = {{&pixel_, 1, 1, 1}, hal::MonotonicClock{}.now(), sequence_++};
    ++lent_;
    return Status::ok;
  }

  void release(hal::Frame& frame) noexcept {
    const Touch touch{*this};
    frame = {};
    --lent_;
  }

 private:
  struct Touch {
    explicit Touch(MoodyCamera& camera) noexcept : camera_{camera} {
      if (camera_.hands_.fetch_add(1) != 0) ++camera_.touched_at_once;
    }
    ~Touch() { camera_.hands_.fetch_sub(1); }
    MoodyCamera& camera_;
  };

  std::uint8_t pixel_{100};
  std::uint32_t sequence_{};  // plain on purpose: a thread sanitizer sees who touches them
  int lent_{};
  bool capturing_{false};
  std::atomic<int> hands_{};
};
static_assert(hal::CameraPort<MoodyCamera>);

}  // namespace articam::test
