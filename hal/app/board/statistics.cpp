#include "hal/app/board/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace articam::app {
namespace {

void add_turn(LoopWindow& window, const Statistics::Turn& turn, double period_s, const hal::Counters& counters) {
  if (period_s > 0) {
    window.period_min_s = window.span_s > 0 ? std::min(window.period_min_s, period_s) : period_s;
    window.period_max_s = std::max(window.period_max_s, period_s);
    window.period_sum_s += period_s;
    window.period_square_sum_s2 += period_s * period_s;
    window.span_s += period_s;
    ++window.ticks;
  }
  if (turn.tick == hal::Tick::estimated) {
    const double age_s = seconds_between(turn.t_capture, turn.now);
    ++window.estimates;
    window.age_sum_s += age_s;
    window.age_max_s = std::max(window.age_max_s, age_s);
  }
  window.counters = counters;
  window.status = turn.status;
  window.reason = turn.reason;
}

double mean(double sum, std::uint64_t n) { return n > 0 ? sum / static_cast<double>(n) : 0; }

}  // namespace

WindowText::WindowText(const LoopWindow& w) noexcept {
  const double period_s = mean(w.period_sum_s, w.ticks);
  const double variance = mean(w.period_square_sum_s2, w.ticks) - period_s * period_s;
  const double jitter_s = std::sqrt(std::max(0.0, variance));
  const auto [end, size] =
      fmt::format_to_n(text_.data(), text_.size(),
                       "{:.1f} Hz  period {:.2f} ms (jitter {:.3f}, {:.2f} to {:.2f})  age {:.2f} ms (max {:.2f})  "
                       "dropped {}  refused {}  silent {}  late {}  camera errors {}  unsent {}  {} ({})",
                       period_s > 0 ? 1 / period_s : 0, 1e3 * period_s, 1e3 * jitter_s, 1e3 * w.period_min_s,
                       1e3 * w.period_max_s, 1e3 * mean(w.age_sum_s, w.estimates), 1e3 * w.age_max_s,
                       w.counters.dropped, w.counters.refused, w.counters.timeouts, w.counters.late,
                       w.counters.camera_errors, w.counters.link_errors, name(w.status), name(w.reason));
  size_ = std::min(size, text_.size());
}

Statistics::Statistics(bool prints) {
  if (prints) printer_ = std::thread{[this] { print(); }};
}

Statistics::~Statistics() {
  ends_ = true;
  wake_.post();
  if (printer_.joinable()) printer_.join();
}

void Statistics::add(const Turn& turn, const hal::Counters& counters) noexcept {
  if (!any_) any_ = true, t_last_ = t_window_ = turn.now;
  const double period_s = seconds_between(t_last_, turn.now);
  t_last_ = turn.now;
  add_turn(total_, turn, period_s, counters);
  add_turn(window_, turn, period_s, counters);
  // A printer that is still busy gets a longer window later.
  if (seconds_between(t_window_, turn.now) < 1 || told_full_.load(std::memory_order_acquire)) return;
  told_ = window_;
  told_full_.store(true, std::memory_order_release);
  if (printer_.joinable()) wake_.post();
  window_ = {};
  t_window_ = turn.now;
}

void Statistics::print() noexcept {
  for (;;) {
    wake_.wait();
    if (ends_) return;
    const WindowText line{told_};
    std::fwrite(line.text().data(), 1, line.text().size(), stderr);
    std::fputc('\n', stderr);
    told_full_.store(false, std::memory_order_release);
  }
}

}  // namespace articam::app
