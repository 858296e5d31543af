#pragma once
/// @file  How one thread wakes another without a lock.

#include <semaphore.h>
#include <time.h>

#include <atomic>
#include <cerrno>
#include <chrono>

namespace articam::hal {

/// Each raise lets one wait pass, in whichever order they come. What was written before the raise can be read after
/// the wait. No heap, and a raise never waits.
class Signal {
 public:
  Signal() noexcept { ::sem_init(&semaphore_, 0, 0); }
  ~Signal() { ::sem_destroy(&semaphore_); }
  Signal(const Signal&) = delete;
  Signal& operator=(const Signal&) = delete;

  void raise() noexcept {
    order_.fetch_add(1, std::memory_order_release);
    ::sem_post(&semaphore_);
  }

  void wait() noexcept {
    while (::sem_wait(&semaphore_) != 0) continue;  // an interrupted wait is taken up again
    order_.fetch_add(1, std::memory_order_acquire);
  }

  /// False when nobody raised it within so long.
  bool wait(std::chrono::milliseconds at_most) noexcept {
    timespec until{};
    ::clock_gettime(CLOCK_MONOTONIC, &until);
    const auto ns = std::chrono::nanoseconds{at_most}.count() + until.tv_nsec;
    until.tv_sec += static_cast<time_t>(ns / 1'000'000'000);
    until.tv_nsec = static_cast<long>(ns % 1'000'000'000);
    while (::sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &until) != 0) {
      if (errno != EINTR) return false;
    }
    order_.fetch_add(1, std::memory_order_acquire);
    return true;
  }

  /// Forgets what was raised; only while no other thread uses it.
  void clear() noexcept {
    while (::sem_trywait(&semaphore_) == 0) continue;
  }

 private:
  sem_t semaphore_{};
  std::atomic<unsigned> order_{};  ///< says in the language's own words what the semaphore orders
};

}  // namespace articam::hal
