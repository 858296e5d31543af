#pragma once
/// @file  A camera that is started anew when it falls silent or is unplugged, while the loop keeps its pace.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

#include "hal/ports/camera_port.hpp"
#include "hal/ports/clock_port.hpp"
#include "hal/posix/semaphore.hpp"

namespace articam::hal {

struct SupervisionOptions {
  std::chrono::nanoseconds period{};  ///< of the frames
  int silent_periods{10};             ///< without a frame: the capture has stalled
  std::chrono::milliseconds first_pause{100};
  std::chrono::milliseconds longest_pause{1000};  ///< between two attempts; the pauses double up to here
};

/// The pause after one that did not help.
constexpr std::chrono::milliseconds longer_pause(std::chrono::milliseconds pause,
                                                 const SupervisionOptions& options) noexcept {
  return std::min(2 * pause, options.longest_pause);
}

/// Wraps a camera that it does not own. At any time one thread alone touches the camera: the loop's while it runs, a
/// second one while it is stopped and started anew. No lock is taken; the heap is used in start() alone (and by the
/// camera's own start). Call start() before the loop's thread becomes a real-time one: the second thread inherits its
/// priority.
template <CameraPort Camera, ClockPort Clock>
class SupervisedCamera {
 public:
  struct Counts {
    std::uint64_t restarts{};         ///< that brought the camera back
    std::uint64_t failed_attempts{};  ///< to start it anew
  };

  SupervisedCamera(Camera& camera, const Clock& clock, SupervisionOptions options) noexcept
      : camera_{camera}, clock_{clock}, options_{options} {}
  ~SupervisedCamera() { stop(); }
  SupervisedCamera(const SupervisedCamera&) = delete;
  SupervisedCamera& operator=(const SupervisedCamera&) = delete;

  /// Starts the camera on this thread; a camera that is missing now is the caller's to report, nothing is retried.
  Status start() noexcept {
    stop();
    if (const Status status = camera_.start(); status != Status::ok) return status;
    t_last_frame_ = clock_.now();
    stopping_ = false;
    try {
      attendant_ = std::thread{[this] { attend(); }};
    } catch (...) {  // no more threads
      camera_.stop();
      return Status::io_error;
    }
    return Status::ok;
  }

  /// Waits for an attempt under way to end.
  void stop() noexcept {
    if (attendant_.joinable()) {
      stopping_ = true;
      broken_.post();
      attendant_.join();
    }
    broken_.clear();
    revived_.clear();
    restarting_ = false;
    camera_.stop();
  }

  /// As the camera's; while it is being started anew, waits as long and says what was wrong with it: no_device when it
  /// was or is gone, timeout when it stalled.
  Status acquire(Frame& out, std::chrono::milliseconds wait) noexcept {
    if (restarting_) {
      if (!revived_.wait(wait)) return why_.load(std::memory_order_relaxed);
      restarting_ = false;
      t_last_frame_ = clock_.now();
      return Status::timeout;  // the wait is used up in part: the next call takes the first frame
    }
    const Status status = camera_.acquire(out, wait);
    const Timestamp now = clock_.now();
    if (status == Status::ok) t_last_frame_ = now;
    if (status == Status::ok || status == Status::end_of_stream) return status;
    const bool silent = seconds_between(t_last_frame_, now) >= options_.silent_periods * period_s();
    if (status == Status::no_device || silent) hand_over(status == Status::no_device ? status : Status::timeout);
    return status;
  }

  /// Only the camera that lent the frame can take it back: frames are never out while it is started anew.
  void release(Frame& frame) noexcept { camera_.release(frame); }

  bool restarting() const noexcept { return restarting_; }  ///< ask in the loop's thread; then leave the camera alone
  Counts counts() const noexcept { return {restarts_.load(), failed_attempts_.load()}; }

 private:
  double period_s() const noexcept { return std::chrono::duration<double>(options_.period).count(); }

  void hand_over(Status why) noexcept {
    why_.store(why, std::memory_order_relaxed);
    restarting_ = true;
    broken_.post();
  }

  /// The second thread: sleeps until the camera is handed over, gives it back when it captures.
  void attend() noexcept {
    for (;;) {
      broken_.wait();
      if (stopping_) return;
      camera_.stop();
      auto pause = options_.first_pause;
      while (!attempt()) {
        if (broken_.wait(pause)) return;  // posted by stop() alone while the camera is here
        pause = longer_pause(pause, options_);
      }
      if (stopping_) return;
      restarts_.fetch_add(1);
      revived_.post();
    }
  }

  bool attempt() noexcept {
    const Status status = camera_.start();
    if (status == Status::ok) return true;
    failed_attempts_.fetch_add(1);
    if (status == Status::no_device) why_.store(status, std::memory_order_relaxed);
    return false;
  }

  Camera& camera_;
  const Clock& clock_;
  SupervisionOptions options_;
  Timestamp t_last_frame_{};  ///< or of the start
  bool restarting_{false};    ///< the camera is the attendant's until it posts revived_; the loop's own note
  std::atomic<Status> why_{Status::timeout};
  std::atomic<bool> stopping_{false};
  std::atomic<std::uint64_t> restarts_{}, failed_attempts_{};
  Semaphore broken_;   ///< to the attendant: the camera is yours, or the end
  Semaphore revived_;  ///< to the loop: it is yours again
  std::thread attendant_;
};

}  // namespace articam::hal
