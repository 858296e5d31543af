#pragma once
/// @file  How far a run has come, for a person at a terminal.

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace articam::sim {

/// Draws on stderr, only if that is a terminal and only after half a second, so that short runs stay quiet.
class ProgressBar {
 public:
  explicit ProgressBar(std::size_t total) noexcept : total_{total} {}
  ~ProgressBar() {
    if (shown_) fmt::print(stderr, "\r{:70}\r", "");
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done) {
    constexpr std::chrono::milliseconds kQuiet{500}, kRedraw{100};
    constexpr std::size_t kWidth = 40;
    const auto now = Clock::now();
    if (!terminal_ || now - start_ < kQuiet || now - drawn_ < kRedraw) return;
    drawn_ = now;
    shown_ = true;
    const std::size_t full = kWidth * done / total_;
    fmt::print(stderr, "\r[{}{}] {} of {} frames", std::string(full, '#'), std::string(kWidth - full, '.'), done,
               total_);
    std::fflush(stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t total_;
  bool terminal_{isatty(STDERR_FILENO) == 1};
  bool shown_{false};
  Clock::time_point start_{Clock::now()}, drawn_{};
};

}  // namespace articam::sim
