#pragma once
/// @file  How a frame crosses from the capturing thread to the loop: one place, the newest wins.

#include <semaphore.h>
#include <time.h>

#include <atomic>
#include <cerrno>
#include <chrono>

namespace articam::hal {

/// Hands buffer numbers from one thread that posts to one that takes. Lock-free and without the heap; a post never
/// waits. What belongs to a buffer may be written before its post and read after its take.
class NewestFrame {
 public:
  static constexpr int kNone = -1;
  static constexpr int kClosed = -2;

  NewestFrame() noexcept { ::sem_init(&full_, 0, 0); }
  ~NewestFrame() { ::sem_destroy(&full_); }
  NewestFrame(const NewestFrame&) = delete;
  NewestFrame& operator=(const NewestFrame&) = delete;

  /// Gives back the buffer that nobody took in time and that is the poster's again, or kNone.
  int post(int buffer) noexcept {
    const int overtaken = slot_.exchange(buffer, std::memory_order_acq_rel);
    if (overtaken == kNone) ::sem_post(&full_);
    return overtaken;
  }

  /// No frame will follow. Any thread; every take from now on answers kClosed.
  void close() noexcept {
    if (!closed_.exchange(true, std::memory_order_acq_rel)) ::sem_post(&full_);
  }

  /// Waits at most so long for a buffer; kNone when there is none, kClosed when there will be none.
  int take(std::chrono::milliseconds wait) noexcept {
    if (closed_.load(std::memory_order_acquire)) return kClosed;
    if (!wait_until_full(wait)) return kNone;
    if (closed_.load(std::memory_order_acquire)) return kClosed;
    // The semaphore counts how often the slot went from empty to full, so here it is full.
    return slot_.exchange(kNone, std::memory_order_acq_rel);
  }

  /// Empty and open again; only while nobody posts or takes.
  void reset() noexcept {
    slot_ = kNone;
    closed_ = false;
    while (::sem_trywait(&full_) == 0) continue;
  }

 private:
  bool wait_until_full(std::chrono::milliseconds wait) noexcept {
    timespec until{};
    ::clock_gettime(CLOCK_MONOTONIC, &until);
    const auto ns = std::chrono::nanoseconds{wait}.count() + until.tv_nsec;
    until.tv_sec += static_cast<time_t>(ns / 1'000'000'000);
    until.tv_nsec = static_cast<long>(ns % 1'000'000'000);
    int result = 0;
    do result = ::sem_clockwait(&full_, CLOCK_MONOTONIC, &until);
    while (result != 0 && errno == EINTR);
    return result == 0;
  }

  sem_t full_{};
  std::atomic<int> slot_{kNone};
  std::atomic<bool> closed_{false};
  static_assert(std::atomic<int>::is_always_lock_free);
};

}  // namespace articam::hal
