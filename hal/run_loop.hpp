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
  refused,    ///< a duplicate or out-of-order frame; nothing changed, nothing went out
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
      auto estimate = tracker_.coast(clock_.now());
      estimate.frame = last_sequence_;
      return publish(estimate, status == Status::timeout ? Tick::coasted : Tick::failed);
    }
    if (!is_new(frame)) {
      camera_.release(frame);
      ++counters_.refused;
      return Tick::refused;
    }
    auto estimate = tracker_.step(frame.pixels, frame.t_exposure);
    estimate.frame = frame.sequence;
    camera_.release(frame);
    ++counters_.frames;
    return publish(estimate, Tick::estimated);
  }

  const Counters& counters() const noexcept { return counters_; }

 private:
  /// Later than the last one by its number (which may wrap round) and by its stamp.
  bool is_new(const Frame& frame) noexcept {
    if (any_frame_) {
      const auto ahead = static_cast<std::int32_t>(frame.sequence - last_sequence_);
      if (ahead <= 0 || frame.t_exposure <= t_last_) return false;
      counters_.dropped += static_cast<std::uint64_t>(ahead - 1);
    }
    any_frame_ = true;
    last_sequence_ = frame.sequence;
    t_last_ = frame.t_exposure;
    return true;
  }

  Tick publish(const typename Tracker::EstimateType& estimate, Tick done) noexcept {
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
  bool any_frame_{false};
  std::uint32_t last_sequence_{};
  Timestamp t_last_{};
};

}  // namespace articam::hal
