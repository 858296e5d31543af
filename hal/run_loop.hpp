#pragma once
/// @file  Joins ports and tracker: the same loop on the board and in the simulator.

#include <chrono>
#include <cstdint>

#include "core/status.hpp"
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
  std::uint64_t camera_errors{};
  std::uint64_t link_errors{};  ///< estimates that did not go out
};

/// One camera, one clock, one link and one tracker, all owned by the caller and outliving the loop.
template <CameraPort Camera, ClockPort Clock, class Link, class Tracker>
requires LinkPort<Link, typename Tracker::EstimateType>
class RunLoop {
 public:
  /// `wait`: after so long without a frame the tick coasts; a little over one frame period.
  RunLoop(Camera& camera, Clock& clock, Link& link, Tracker& tracker, std::chrono::milliseconds wait) noexcept
      : camera_{camera}, clock_{clock}, link_{link}, tracker_{tracker}, wait_{wait} {}

  Status start() noexcept { return camera_.start(); }

  Tick run_once() noexcept {
    Frame frame;
    const Status status = camera_.acquire(frame, wait_);
    if (status == Status::end_of_stream) return Tick::ended;
    if (status != Status::ok) {
      ++(status == Status::timeout ? counters_.timeouts : counters_.camera_errors);
      may_restart_ = true;
      return publish(tracker_.coast(clock_.now()), status == Status::timeout ? Tick::coasted : Tick::failed);
    }
    if (!is_next(frame)) {
      camera_.release(frame);
      ++counters_.refused;
      if (++refused_in_a_row_ >= kRefusalsToRestart) may_restart_ = true;
      return publish(tracker_.coast(clock_.now()), Tick::refused);
    }
    const auto estimate = tracker_.step(frame.pixels, frame.t_exposure);
    camera_.release(frame);
    ++counters_.frames;
    return publish(estimate, Tick::estimated);
  }

  const Counters& counters() const noexcept { return counters_; }

 private:
  /// Later than the last one by its number (which may wrap round) and by its stamp, and not of the future. After a
  /// silence the camera may have been started anew and count from anywhere; its stamps still only rise.
  bool is_next(const Frame& frame) noexcept {
    if (frame.t_exposure > clock_.now()) return false;
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

  Tick publish(typename Tracker::EstimateType estimate, Tick done) noexcept {
    estimate.frame = number_;
    if (link_.publish(estimate) == Status::ok) return done;
    ++counters_.link_errors;
    return Tick::failed;
  }

  Camera& camera_;
  Clock& clock_;
  Link& link_;
  Tracker& tracker_;
  std::chrono::milliseconds wait_;
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
