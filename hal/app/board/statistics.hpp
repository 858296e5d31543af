#pragma once
/// @file  How regularly the loop runs, once a second, told by a thread that may wait for its terminal.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <thread>

#include "core/timestamp.hpp"
#include "core/tracker/estimate.hpp"
#include "hal/posix/semaphore.hpp"
#include "hal/run_loop.hpp"

namespace articam::app {

/// What the loop did in a span of time.
struct LoopWindow {
  std::uint64_t ticks{};
  double span_s{};
  double period_sum_s{}, period_square_sum_s2{}, period_min_s{}, period_max_s{};  ///< from tick to tick
  std::uint64_t estimates{};                                                      ///< ticks with a frame
  double age_sum_s{}, age_max_s{};                                                ///< mid-exposure to link
  hal::Counters counters{};                                                       ///< since the start
  tracker::TrackingStatus status{};
  tracker::Reason reason{};
};

/// One line for a person, without the heap.
class WindowText {
 public:
  explicit WindowText(const LoopWindow& window) noexcept;
  std::string_view text() const noexcept { return {text_.data(), size_}; }

 private:
  std::array<char, 512> text_;
  std::size_t size_{};
};

/// Gathers in the loop's thread without waiting or allocating, and prints from a thread of its own.
class Statistics {
 public:
  explicit Statistics(bool prints);
  Statistics(const Statistics&) = delete;
  Statistics& operator=(const Statistics&) = delete;
  ~Statistics();

  struct Turn {
    Timestamp now{};
    hal::Tick tick{};
    Timestamp t_capture{};
    tracker::TrackingStatus status{};
    tracker::Reason reason{};
  };
  void add(const Turn& turn, const hal::Counters& counters) noexcept;

  const LoopWindow& total() const noexcept { return total_; }

 private:
  void print() noexcept;

  LoopWindow total_, window_;  ///< the loop's
  Timestamp t_last_{}, t_window_{};
  bool any_{false};

  LoopWindow told_;  ///< the printer's while told_full_
  std::atomic<bool> told_full_{false}, ends_{false};
  hal::Semaphore wake_;
  std::thread printer_;
};

}  // namespace articam::app
