#pragma once
/// @file  How a buffer goes back to the camera without the loop waiting for the library.

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

#include "hal/posix/semaphore.hpp"

namespace articam::hal {

/// Calls `queue` for every buffer given back, on a thread of its own. Each is called for at once: nothing waits for a
/// next frame, so a camera that has no buffer left gets them too. The heap is used in start() alone.
class Requeuer {
 public:
  static constexpr int kMaxBuffers = 32;

  ~Requeuer() { stop(); }

  /// Throws std::system_error where there is no thread to be had.
  void start(std::function<void(int buffer)> queue) {
    stopping_ = false;
    thread_ = std::thread{[this, queue = std::move(queue)] { run(queue); }};
  }

  /// What was given back and not queued yet is forgotten; allowed in any state.
  void stop() noexcept {
    if (!thread_.joinable()) return;
    stopping_ = true;
    wake_.post();
    thread_.join();
    wake_.clear();
    given_back_ = 0;
  }

  /// From any one thread; never waits. `buffer` is below kMaxBuffers.
  void give_back(int buffer) noexcept {
    given_back_.fetch_or(std::uint32_t{1} << buffer, std::memory_order_release);
    wake_.post();
  }

 private:
  void run(const std::function<void(int)>& queue) {
    for (;;) {
      wake_.wait();
      if (stopping_) return;
      const std::uint32_t buffers = given_back_.exchange(0, std::memory_order_acquire);
      for (int i = 0; i < kMaxBuffers; ++i) {
        if ((buffers >> i & 1) != 0) queue(i);
      }
    }
  }

  Semaphore wake_;
  std::atomic<std::uint32_t> given_back_{};  ///< a bit a buffer
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace articam::hal
