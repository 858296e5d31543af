#pragma once
/// @file  How one thread wakes another without a lock.

#include <semaphore.h>
#include <time.h>

#include <atomic>
#include <cerrno>
#include <chrono>

#include "hal/posix/monotonic_clock.hpp"

namespace articam::hal {

/// Each post lets one wait pass, in whichever order they come. What was written before the post can be read after the
/// wait. No heap, and a post never waits.
class Semaphore {
 public:
  Semaphore() noexcept { ::sem_init(&semaphore_, 0, 0); }
  ~Semaphore() { ::sem_destroy(&semaphore_); }
  Semaphore(const Semaphore&) = delete;
  Semaphore& operator=(const Semaphore&) = delete;

  void post() noexcept {
    order_.fetch_add(1, std::memory_order_release);
    ::sem_post(&semaphore_);
  }

  void wait() noexcept {
    while (::sem_wait(&semaphore_) != 0) continue;  // an interrupted wait is taken up again
    order_.fetch_add(1, std::memory_order_acquire);
  }

  /// False when there was no post within so long.
  bool wait(std::chrono::milliseconds at_most) noexcept {
    const std::int64_t until_ns = MonotonicClock{}.now().ns + std::chrono::nanoseconds{at_most}.count();
    timespec until{};
    until.tv_sec = static_cast<time_t>(until_ns / 1'000'000'000);
    until.tv_nsec = static_cast<long>(until_ns % 1'000'000'000);
    while (::sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &until) != 0) {
      if (errno != EINTR) return false;
    }
    order_.fetch_add(1, std::memory_order_acquire);
    return true;
  }

  /// Forgets what was posted; only while no other thread uses it.
  void clear() noexcept {
    while (::sem_trywait(&semaphore_) == 0) continue;
  }

 private:
  sem_t semaphore_{};
  std::atomic<unsigned> order_{};  ///< says in the language's own words what the semaphore orders
};

}  // namespace articam::hal
