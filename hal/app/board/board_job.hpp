#pragma once
/// @file  The board's program: one model, one camera file; ports, tracker and link joined by the loop.

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.hpp"
#include "core/model/table_hash.hpp"
#include "core/tracker/tracker.hpp"
#include "hal/app/board/board_link.hpp"
#include "hal/app/board/board_options.hpp"
#include "hal/app/board/statistics.hpp"
#include "hal/app/start.hpp"
#include "hal/link/tee_link.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/posix/realtime.hpp"
#include "hal/record/recording_ports.hpp"
#include "hal/run_loop.hpp"
#include "hal/systemd/service.hpp"

namespace articam::app {

/// Set by SIGTERM, SIGINT and SIGHUP; the loop ends with the tick that it is in.
extern volatile std::sig_atomic_t g_stop_asked;
void stop_on_signals();

/// What a user should know and nobody needs to die of.
void warn(const std::string& program, const std::string& text);

template <class Model>
class BoardJob {
 public:
  BoardJob(const BoardTitle& title, const BoardOptions& options, const CameraParameters& camera)
      : title_{title}, options_{options}, parameters_{camera}, tracker_{camera, {.mode = options.mode}} {}

  /// Runs until it is asked to stop or `camera` ends. Returns what went wrong, or nothing.
  template <hal::CameraPort Camera>
  std::string run(Camera& camera) {
    if (const auto problem = prepare(); !problem.empty()) return problem;
    hal::RecordingCamera recording_camera{camera, recorder_};
    hal::RecordingClock recording_clock{clock_, recorder_};
    hal::RecordingTracker recording_tracker{tracker_, recorder_};
    hal::RunLoop loop{recording_camera, recording_clock, tee_, recording_tracker, times_};
    Statistics statistics{!options_.quiet};
    for (const auto& warning : {hal::lock_memory(), options_.cpu ? hal::bind_to_cpu(*options_.cpu) : std::string{},
                                options_.priority > 0 ? hal::set_fifo_priority(options_.priority) : std::string{}}) {
      if (!warning.empty()) warn(title_.name, warning);
    }
    service_.tell_ready();
    const hal::MemoryUse before = hal::memory_use();
    turn(loop, statistics);
    const hal::MemoryUse after = hal::memory_use();
    service_.tell_stopping();
    loop.stop();
    return conclude(statistics, before, after);
  }

 private:
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  using Estimate = typename Tracker::EstimateType;

  std::string prepare() {
    const auto numbers = parse_numbers(options_.q0);
    if (!options_.q0.empty()) {
      if (const auto problem = set_start(tracker_, numbers, options_.q0); !problem.empty()) return problem;
    }
    if (const auto problem = link_.open(options_, parameters_); !problem.empty()) return problem;
    const hal::RecordingHeader header = recording_header(options_.q0.empty() ? std::vector<double>{} : *numbers);
    const auto slots = static_cast<std::uint32_t>(options_.record_seconds * options_.rate_hz + 1);
    const bool recording =
        (options_.record.empty() ||
         recorder_.open_ticks(options_.record, options_.record_mb << 20, header) == Status::ok) &&
        (options_.record_frames.empty() || recorder_.open_frames(options_.record_frames, slots, header) == Status::ok);
    return recording ? std::string{} : recorder_.problem();
  }

  hal::RecordingHeader recording_header(const std::vector<double>& start) const {
    hal::RecordingHeader header;
    header.model_hash = model::table_hash<Model>();
    header.scalar_bytes = sizeof(DefaultScalar);
    std::string_view{Model::kName}.copy(header.model_name.data(), header.model_name.size() - 1);
    header.period_ns = times_.period.count();
    header.max_age_s = times_.max_age_s;
    header.camera = parameters_;
    header.options = tracker_.options();
    header.num_start = start.size();
    std::copy(start.begin(), start.end(), header.start.begin());
    return header;
  }

  template <class Loop>
  void turn(Loop& loop, Statistics& statistics) {
    while (g_stop_asked == 0) {
      const hal::Tick tick = loop.run_once();
      if (tick == hal::Tick::ended) return;
      const Timestamp now = clock_.now();
      const Estimate& estimate = tee_.latest();
      statistics.add({now, tick, estimate.t_capture, estimate.status, estimate.reason}, loop.counters());
      service_.feed_watchdog(now);
      if (options_.num_frames > 0 && loop.counters().frames >= options_.num_frames) return;
    }
  }

  std::string conclude(const Statistics& statistics, const hal::MemoryUse& before, const hal::MemoryUse& after) {
    const bool recorded = recorder_.close() == Status::ok;
    const hal::Recorder::Counters& kept = recorder_.counters();
    if (!options_.quiet) {
      fmt::print(stderr, "total  {} frames  {}\n", statistics.total().counters.frames,
                 WindowText{statistics.total()}.text());
      fmt::print(stderr, "since the start  page faults {}  heap growth {} bytes\n",
                 after.minor_faults + after.major_faults - before.minor_faults - before.major_faults,
                 after.heap_bytes - before.heap_bytes);
      if (!options_.record.empty()) {
        fmt::print(stderr, "recorded  {} ticks (missed {})  {} frames (missed {})\n", kept.ticks, kept.ticks_missed,
                   kept.frames, kept.frames_missed);
      }
    }
    return recorded ? std::string{} : recorder_.problem();
  }

  BoardTitle title_;
  BoardOptions options_;
  CameraParameters parameters_;
  hal::LoopTimes times_{.period = std::chrono::nanoseconds(from_seconds(1 / options_.rate_hz).ns)};
  const hal::MonotonicClock clock_{};
  Tracker tracker_;
  hal::Recorder recorder_;
  BoardLink<Estimate> link_;
  hal::TeeLink<Estimate, BoardLink<Estimate>> tee_{link_};  // the newest one also to the statistics
  hal::Service service_;
};

}  // namespace articam::app
