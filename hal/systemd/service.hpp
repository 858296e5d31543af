#pragma once
/// @file  The words between this program and systemd. Without systemd they go nowhere.

#include <chrono>

namespace articam::hal {

/// Ready, once: capture runs.
void tell_ready() noexcept;
/// The end has begun. Like the others it waits while systemd's own queue is full.
void tell_stopping() noexcept;

/// Feeds systemd's watchdog, every quarter of WatchdogSec at most. Whoever calls feed() is what is watched.
class Watchdog {
 public:
  Watchdog() noexcept;
  void feed(std::chrono::steady_clock::time_point now) noexcept;

 private:
  std::chrono::nanoseconds interval_{};  ///< 0: nobody watches
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace articam::hal
