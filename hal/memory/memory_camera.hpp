#pragma once
/// @file  A camera whose frames somebody hands over: a DMA interrupt on bare metal, a test on the host.

#include "hal/ports/camera_port.hpp"

namespace articam::hal {

/// Holds one frame at a time; the newest wins. Hand over and acquire from the same context.
class MemoryCamera {
 public:
  Status start() noexcept { return Status::ok; }
  void stop() noexcept { waiting_ = false; }

  /// The pixels must stay valid until the loop has released them.
  void hand_over(const Frame& frame) noexcept {
    frame_ = frame;
    waiting_ = true;
  }

  Status acquire(Frame& out, std::chrono::milliseconds) noexcept {
    if (!waiting_) return Status::timeout;
    out = frame_;
    waiting_ = false;
    return Status::ok;
  }
  void release(Frame& frame) noexcept { frame = {}; }

 private:
  Frame frame_{};
  bool waiting_{false};
};
static_assert(CameraPort<MemoryCamera>);

}  // namespace articam::hal
