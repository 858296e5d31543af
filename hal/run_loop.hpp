#pragma once
/// @file  Joins ports and tracker: the same loop on the board and in the simulator.

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "core/status.hpp"
#include "core/tracker/estimate.hpp"
#include "hal/ports/camera_port.hpp"
#include "hal/ports/clock_port.hpp"
#include "hal/ports/link_port.hpp"

namespace articam::hal {

/// What one turn of the loop has done.
enum class Tick : std::uint8_t {
  estimated,  ///< a frame became an estimate, and it went out
  coasted,    ///< no frame in time; an estimate that says so went out
  refused,    ///< a frame that cannot be the next one; the tracker did not see it, an estimate that coasts went out
  ended,      ///< the recording has no more frames
  failed,     ///< camera or link reported an error; see Counters
};

struct Counters {
  std::uint64_t frames{};    ///< estimates made from a frame
  std::uint64_t dropped{};   ///< frames missing by their sequence numbers
  std::uint64_t refused{};   ///< duplicates and frames out of order
  std::uint64_t timeouts{};  ///< ticks without a frame
  std::uint64_t late{};      ///< estimates that came out older than LoopTimes::max_age_s
  std::uint64_t camera_errors{};
  std::uint64_t link_errors{};  ///< estimates that did not go out
};

/// What the loop expects of time. A silent camera is judged in frame periods.
struct LoopTimes {
  std::chrono::nanoseconds period{};  ///< of the camera, nominal
  double max_age_s{0.1};              ///< from mid-exposure to the link; an older result is flagged late_result

  static constexpr double kStalled_periods = 2.5;  ///< silent for longer: degraded, camera_stalled
  static constexpr double kLost_periods = 10;      ///< silent for longer: lost
  /// After so long without a frame the tick speaks without one.
  constexpr std::chrono::milliseconds wait() const noexcept {
    constexpr std::chrono::milliseconds kMost{500};  // a slow camera is no reason to be silent, nor a dead loop's
    return std::min(kMost, std::chrono::ceil<std::chrono::milliseconds>(period + period / 4));
  }
};

/// One camera, one clock, one link and one tracker, all owned by the caller and outliving the loop.
template <CameraPort Camera, ClockPort Clock, class Link, class Tracker>
requires LinkPort<Link, typename Tracker::EstimateType>
class RunLoop {
 public:
  using EstimateType = typename Tracker::EstimateType;

  RunLoop(Camera& camera, Clock& clock, Link& link, Tracker& tracker, const LoopTimes& times) noexcept
      : camera_{camera}, clock_{clock}, link_{link}, tracker_{tracker}, times_{times} {}

  Status start() noexcept { return camera_.start(); }
  void stop() noexcept { camera_.stop(); }

  Tick run_once() noexcept {
    Frame frame;
    const Status status = camera_.acquire(frame, times_.wait());
    if (status == Status::end_of_stream) return Tick::ended;
    const Timestamp now = clock_.now();
    if (status != Status::ok) {
      ++(status == Status::timeout ? counters_.timeouts : counters_.camera_errors);
      may_restart_ = true;
      return publish(without_frame(status, tracker::Reason::no_frame, now),
                     status == Status::timeout ? Tick::coasted : Tick::failed);
    }
    if (!is_next(frame, now)) {
      camera_.release(frame);
      ++counters_.refused;
      if (++refused_in_a_row_ >= kRefusalsToRestart) may_restart_ = true;
      return publish(without_frame(status, tracker::Reason::stale_frame, now), Tick::refused);
    }
    EstimateType estimate = tracker_.step(frame.pixels, t_last_);
    camera_.release(frame);
    ++counters_.frames;
    if (seconds_between(t_last_, clock_.now()) > times_.max_age_s) {
      ++counters_.late;
      if (estimate.reason == tracker::Reason::none) estimate.reason = tracker::Reason::late_result;
    }
    return publish(estimate, Tick::estimated);
  }

  const Counters& counters() const noexcept { return counters_; }

 private:
  /// Later than the last one by its number (which may wrap round) and by its stamp, and not of the future. After a
  /// silence the camera may have been started anew and count from anywhere; its stamps still only rise.
  bool is_next(const Frame& frame, Timestamp now) noexcept {
    if (frame.t_exposure > now) return false;
    if (any_frame_) {
      const auto ahead = static_cast<std::int32_t>(frame.sequence - last_sequence_);
      if (frame.t_exposure <= t_last_ || (ahead <= 0 && !may_restart_)) return false;
      if (ahead > 0) {
        counters_.dropped += static_cast<std::uint64_t>(ahead - 1);
        number_ += static_cast<std::uint32_t>(ahead);
      } else {
        ++number_;
      }
    }
    any_frame_ = true;
    may_restart_ = false;
    refused_in_a_row_ = 0;
    last_sequence_ = frame.sequence;
    t_last_ = frame.t_exposure;
    return true;
  }

  /// The prediction, for as long as a silent camera can be believed to come back with the object still near it.
  EstimateType without_frame(Status camera, tracker::Reason why, Timestamp now) const noexcept {
    using tracker::Reason, tracker::TrackingStatus;
    EstimateType estimate = tracker_.coast(now, why);
    if (estimate.reason == Reason::no_start) return estimate;
    const double silent_periods = seconds_between(t_last_, now) / std::chrono::duration<double>(times_.period).count();
    const bool gone = camera == Status::no_device;
    const bool dead = gone || !any_frame_ || silent_periods > LoopTimes::kLost_periods;
    if (dead || silent_periods > LoopTimes::kStalled_periods) {
      estimate.reason = gone ? Reason::camera_gone : Reason::camera_stalled;
      if (estimate.status == TrackingStatus::coasting) {
        estimate.status = dead ? TrackingStatus::lost : TrackingStatus::degraded;
        estimate.valid = !dead;
      }
    }
    return estimate;
  }

  Tick publish(EstimateType estimate, Tick done) noexcept {
    estimate.frame = number_;
    if (link_.publish(estimate) == Status::ok) return done;
    ++counters_.link_errors;
    return Tick::failed;
  }

  Camera& camera_;
  Clock& clock_;
  Link& link_;
  Tracker& tracker_;
  LoopTimes times_;
  Counters counters_{};
  static constexpr int kRefusalsToRestart = 10;  ///< then the camera counts anew, it does not stutter

  bool any_frame_{false};
  int refused_in_a_row_{};
  bool may_restart_{false};        ///< the camera was silent: its sequence may begin anew
  std::uint32_t last_sequence_{};  ///< as the camera counts
  std::uint32_t number_{};         ///< of the last frame, counted from 0 with its gaps
  Timestamp t_last_{};
};

}  // namespace articam::hal
