#include "hal/systemd/service.hpp"

#include <systemd/sd-daemon.h>

#include <cstdint>

namespace articam::hal {

void tell_ready() noexcept { (void)::sd_notify(0, "READY=1"); }
void tell_stopping() noexcept { (void)::sd_notify(0, "STOPPING=1"); }

Watchdog::Watchdog() noexcept {
  std::uint64_t limit_us = 0;
  if (::sd_watchdog_enabled(0, &limit_us) > 0) interval_ = std::chrono::microseconds{limit_us / 4};
}

void Watchdog::feed(std::chrono::steady_clock::time_point now) noexcept {
  if (interval_.count() == 0 || now < next_) return;
  (void)::sd_notify(0, "WATCHDOG=1");
  next_ = now + interval_;
}

}  // namespace articam::hal
