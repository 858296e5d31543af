#pragma once
/// @file  The words between this program and systemd. Without systemd they go nowhere.

#include <sys/socket.h>
#include <sys/un.h>

#include <chrono>
#include <string_view>

#include "core/timestamp.hpp"

namespace articam::hal {

/// Speaks to the service manager that started this program, by the socket that it named. libsystemd's sd_notify waits
/// while the manager's queue is full; a real-time loop must not, so the protocol's three words are said here.
/// Source  sd_notify(3), sd_watchdog_enabled(3): NOTIFY_SOCKET, WATCHDOG_USEC, WATCHDOG_PID.
class Service {
 public:
  Service() noexcept;
  ~Service();
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  void tell_ready() noexcept;     ///< capture runs; waits until there is room
  void tell_stopping() noexcept;  ///< the end has begun; where there is no room it is not said, and no reason to stay

  /// Every quarter of WatchdogSec at most. Whoever calls this is what is watched. Never waits: what finds no room is
  /// said by the next call. No heap.
  void feed_watchdog(Timestamp now) noexcept;

 private:
  bool tell(std::string_view words, int flags) noexcept;

  int socket_{-1};  ///< -1: nobody listens
  sockaddr_un manager_{};
  socklen_t manager_size_{};
  std::chrono::nanoseconds interval_{};  ///< 0: nobody watches
  Timestamp next_{};
};

}  // namespace articam::hal
