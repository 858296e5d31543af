#pragma once
/// @file  How a frame crosses from the capturing thread to the loop: one place, the newest wins.

#include <atomic>
#include <chrono>

#include "hal/posix/semaphore.hpp"

namespace articam::hal {

/// Hands buffer numbers from one thread that posts to one that takes. Lock-free and without the heap; a post never
/// waits. What belongs to a buffer may be written before its post and read after its take.
class NewestFrame {
 public:
  static constexpr int kNone = -1;
  static constexpr int kClosed = -2;

  /// Gives back the buffer that nobody took in time and that is the poster's again, or kNone.
  int post(int buffer) noexcept {
    const int overtaken = slot_.exchange(buffer, std::memory_order_acq_rel);
    if (overtaken == kNone) full_.post();
    return overtaken;
  }

  /// No frame will follow. Any thread; every take from now on answers kClosed.
  void close() noexcept {
    if (!closed_.exchange(true, std::memory_order_acq_rel)) full_.post();
  }

  /// Waits at most so long for a buffer; kNone when there is none, kClosed when there will be none.
  int take(std::chrono::milliseconds wait) noexcept {
    if (closed_.load(std::memory_order_acquire)) return kClosed;
    if (!full_.wait(wait)) return kNone;
    if (closed_.load(std::memory_order_acquire)) return kClosed;
    // The semaphore counts how often the slot went from empty to full, so here it is full.
    return slot_.exchange(kNone, std::memory_order_acq_rel);
  }

  /// Empty and open again; only while nobody posts or takes.
  void reset() noexcept {
    slot_ = kNone;
    closed_ = false;
    full_.clear();
  }

 private:
  Semaphore full_;  ///< posted when the slot goes from empty to full, and on close
  std::atomic<int> slot_{kNone};
  std::atomic<bool> closed_{false};
  static_assert(std::atomic<int>::is_always_lock_free);
};

}  // namespace articam::hal
