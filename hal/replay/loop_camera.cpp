#include "hal/replay/loop_camera.hpp"

#include <algorithm>
#include <exception>
#include <thread>

namespace articam::hal {

Status LoopCamera::start() noexcept {
  running_ = false;
  next_ = 0;
  if (!frames_.empty()) return Status::ok;  // loaded by an earlier start
  try {
    return load();
  } catch (const std::exception& e) {
    problem_ = e.what();
    frames_.clear();
    return Status::io_error;
  }
}

Status LoopCamera::load() {
  if (options_.files.empty()) {
    problem_ = "there are no PGM frames to play";
    return Status::no_device;
  }
  const std::size_t bytes = static_cast<std::size_t>(options_.width_px) * static_cast<std::size_t>(options_.height_px);
  if (options_.files.size() > kMaxBytes / bytes) {
    problem_ = std::to_string(options_.files.size()) + " frames are more than 1 GiB: play fewer";
    return Status::bad_argument;
  }
  std::vector<GreyImage> frames(options_.files.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (const Status status = read_pgm(options_.files[i], frames[i], problem_); status != Status::ok) return status;
    if (frames[i].width_px != options_.width_px || frames[i].height_px != options_.height_px) {
      problem_ = options_.files[i].string() + ": is " + std::to_string(frames[i].width_px) + " x " +
                 std::to_string(frames[i].height_px) + " pixels, but the camera file says " +
                 std::to_string(options_.width_px) + " x " + std::to_string(options_.height_px);
      return Status::bad_argument;
    }
  }
  frames_ = std::move(frames);
  return Status::ok;
}

Status LoopCamera::acquire(Frame& out, std::chrono::milliseconds wait) noexcept {
  if (frames_.empty()) return Status::no_device;
  if (!running_) begin_ = Clock::now(), running_ = true;
  const Timestamp offset = from_seconds(static_cast<double>(next_) / options_.rate_hz);
  const auto due = begin_ + std::chrono::nanoseconds{offset.ns};
  const auto patience = Clock::now() + wait;
  std::this_thread::sleep_until(std::min(due, patience));
  if (due > patience) return Status::timeout;
  const std::chrono::nanoseconds t = due.time_since_epoch();
  out = {frames_[next_ % frames_.size()].view(), Timestamp{t.count()}, static_cast<std::uint32_t>(next_)};
  ++next_;
  return Status::ok;
}

}  // namespace articam::hal
