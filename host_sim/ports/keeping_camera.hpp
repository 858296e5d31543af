#pragma once
/// @file  A camera that shows each frame to somebody before it lends it.

#include <chrono>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "hal/ports/camera_port.hpp"

namespace articam::sim {

/// Passes the frames of `Camera` on. `keep` sees each of them, for example to write it into a file; where that fails,
/// the frame is given back and acquire() ends with its status.
template <hal::CameraPort Camera>
class KeepingCamera {
 public:
  /// Returns why a frame could not be kept in `problem`.
  using Keep = std::function<Status(const hal::Frame&, std::string& problem)>;

  /// An empty `keep` keeps nothing.
  KeepingCamera(Camera& camera, Keep keep) : camera_{camera}, keep_{std::move(keep)} {}

  Status start() noexcept { return camera_.start(); }
  void stop() noexcept { camera_.stop(); }
  Status acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept {
    hal::Frame frame;
    Status status = camera_.acquire(frame, wait);
    if (status != Status::ok) return status;
    if (status = kept(frame); status != Status::ok) {
      camera_.release(frame);
      return status;
    }
    out = frame;
    return Status::ok;
  }
  void release(hal::Frame& frame) noexcept { camera_.release(frame); }

  const std::string& problem() const noexcept { return problem_; }

 private:
  Status kept(const hal::Frame& frame) noexcept {
    try {
      return keep_ ? keep_(frame, problem_) : Status::ok;
    } catch (const std::exception& error) {
      problem_ = error.what();
      return Status::io_error;
    }
  }

  Camera& camera_;
  Keep keep_;
  std::string problem_;
};

}  // namespace articam::sim
