#include "hal/v4l2/v4l2_camera.hpp"

#include <linux/videodev2.h>
#include <poll.h>
#include <time.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <exception>
#include <utility>

#include "hal/v4l2/device_settings.hpp"

namespace articam::hal {
namespace {

Timestamp monotonic_now() noexcept {
  timespec t{};
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  return {static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec};
}

v4l2_buffer mapped_buffer(int index) noexcept {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = static_cast<std::uint32_t>(index);
  return buffer;
}

std::int64_t stamp_ns(const v4l2_buffer& buffer) noexcept {
  return static_cast<std::int64_t>(buffer.timestamp.tv_sec) * 1'000'000'000 +
         static_cast<std::int64_t>(buffer.timestamp.tv_usec) * 1000;
}

bool is_monotonic(const v4l2_buffer& buffer) noexcept {
  return (buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
}

}  // namespace

V4l2Camera::V4l2Camera(V4l2Options options)
    : V4l2Camera{std::move(options), std::make_unique<v4l2::SystemVideoCalls>()} {}
V4l2Camera::V4l2Camera(V4l2Options options, std::unique_ptr<v4l2::VideoCalls> calls)
    : options_{std::move(options)}, calls_{std::move(calls)} {}
V4l2Camera::~V4l2Camera() { stop(); }

Status V4l2Camera::start() noexcept {
  stop();
  Status status = Status::ok;
  problem_ = {};
  try {
    try {
      start_problem_.clear();
      open_and_start();
      await_first_frame();
    } catch (const v4l2::StartProblem& problem) {
      status = problem.status;
      start_problem_ = options_.device + ": " + problem.reason;
    }
    problem_ = start_problem_;
  } catch (const std::exception&) {
    status = Status::io_error;
    problem_ = "no memory is left";
  }
  if (status != Status::ok) stop();
  return status;
}

void V4l2Camera::open_and_start() {
  if (options_.width_px < 1 || options_.width_px > kMaxImageWidth_px || options_.height_px < 1 ||
      options_.height_px > kMaxImageHeight_px) {
    throw v4l2::StartProblem{Status::bad_argument, "the image size is beyond what this program is built for"};
  }
  const int file = calls_->open(options_.device.c_str());
  v4l2::check(file, "be opened");
  file_ = file;
  const v4l2::Settled settled = v4l2::settle({*calls_, file_}, options_);
  layout_ = settled.layout;
  stride_bytes_ = settled.stride_bytes;
  exposure_ns_ = settled.exposure_ns;
  if (!layout_->in_place()) copy_.resize(static_cast<std::size_t>(options_.width_px * options_.height_px));
  map_buffers();
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2::check(calls_->control(file_, VIDIOC_STREAMON, &type), "start the capture");
  description_ = options_.device + ": " + std::to_string(options_.width_px) + " x " +
                 std::to_string(options_.height_px) + ", stride " + std::to_string(stride_bytes_) + ", " +
                 std::to_string(buffers_.size()) + " buffers, luma " +
                 (layout_->in_place() ? "in place" : "copied: it lies between the chroma") +
                 (settled.period_is_the_devices ? ", frame duration is the device's own" : "");
}

void V4l2Camera::map_buffers() {
  v4l2_requestbuffers request{};
  request.count = static_cast<std::uint32_t>(options_.buffers);
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  v4l2::check(calls_->control(file_, VIDIOC_REQBUFS, &request), "make its buffers");
  if (request.count < 2) throw v4l2::StartProblem{Status::io_error, "it gives fewer than two buffers"};
  buffers_.reserve(request.count);
  for (int i = 0; i < static_cast<int>(request.count); ++i) {
    v4l2_buffer buffer = mapped_buffer(i);
    v4l2::check(calls_->control(file_, VIDIOC_QUERYBUF, &buffer), "be asked for its buffers");
    if (!is_monotonic(buffer)) {
      throw v4l2::StartProblem{Status::bad_argument, "its time stamps are not of CLOCK_MONOTONIC"};
    }
    if (buffer.length < bytes_needed()) {
      throw v4l2::StartProblem{Status::bad_argument, "its buffers are too short for the image"};
    }
    void* const data = calls_->map(file_, buffer.length, buffer.m.offset);
    if (data == nullptr) throw v4l2::StartProblem{Status::io_error, "its buffers could not be mapped"};
    buffers_.push_back({static_cast<const std::uint8_t*>(data), buffer.length});
    queue(i);
  }
}

void V4l2Camera::await_first_frame() {
  Dequeued first;
  const std::uint64_t strays = counts_.wrong_stamp;
  const Status status = next_frame(first, options_.first_frame_wait);
  if (status == Status::ok) return queue(first.buffer);
  if (counts_.wrong_stamp != strays) {
    throw v4l2::StartProblem{Status::bad_argument,
                             "its time stamps, " + std::to_string(wrong_stamp_ns_) + " ns, are not within " +
                                 std::to_string(options_.max_age.count()) + " ms before CLOCK_MONOTONIC"};
  }
  throw v4l2::StartProblem{status, "after its start: " + std::string{problem_}};
}

void V4l2Camera::stop() noexcept {
  if (file_ == kNone) return;
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  (void)calls_->control(file_, VIDIOC_STREAMOFF, &type);
  for (const Buffer& buffer : buffers_) calls_->unmap(const_cast<std::uint8_t*>(buffer.data), buffer.length);
  buffers_.clear();
  calls_->close(file_);  // frees the driver's buffers too
  file_ = lent_ = kNone;
  broken_ = false;
}

std::size_t V4l2Camera::bytes_needed() const noexcept {
  return stride_bytes_ * static_cast<std::size_t>(options_.height_px - 1) +
         static_cast<std::size_t>(options_.width_px * layout_->step);
}

Status V4l2Camera::acquire(Frame& out, std::chrono::milliseconds wait) noexcept {
  assert(lent_ == kNone && "one frame is lent at a time");
  Dequeued newest;
  if (const Status status = next_frame(newest, wait); status != Status::ok) return status;
  const std::uint8_t* const data = buffers_[static_cast<std::size_t>(newest.buffer)].data;
  if (layout_->in_place()) {
    lent_ = newest.buffer;
    out = {{data, options_.width_px, options_.height_px, static_cast<std::ptrdiff_t>(stride_bytes_)},
           newest.t_exposure,
           newest.sequence};
    return Status::ok;
  }
  std::uint8_t* to = copy_.data();
  for (int v = 0; v < options_.height_px; ++v) {
    const std::uint8_t* const row = data + static_cast<std::size_t>(v) * stride_bytes_ + layout_->first;
    for (int u = 0; u < options_.width_px; ++u) *to++ = row[u * layout_->step];
  }
  ++counts_.copied;
  out = {{copy_.data(), options_.width_px, options_.height_px, options_.width_px}, newest.t_exposure, newest.sequence};
  queue(newest.buffer);
  return Status::ok;
}

void V4l2Camera::release(Frame& frame) noexcept {
  frame = {};
  if (lent_ != kNone) queue(std::exchange(lent_, kNone));
}

Status V4l2Camera::next_frame(Dequeued& newest, std::chrono::milliseconds wait) noexcept {
  if (file_ == kNone) return fail(Status::no_device, "the device is not started");
  const std::int64_t deadline_ns = monotonic_now().ns + std::chrono::nanoseconds{wait}.count();
  while (!broken_) {
    if (dequeue_all(newest)) return Status::ok;
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(std::chrono::nanoseconds{deadline_ns - monotonic_now().ns});
    if (left.count() <= 0) return fail(Status::timeout, "no frame came in time");
    const int events = calls_->wait(file_, left);
    if (events < 0 || (events & (POLLERR | POLLHUP | POLLNVAL)) != 0) {
      broken_ = true;
    }
  }
  return fail(Status::no_device, "the device was unplugged, or its capture broke");
}

bool V4l2Camera::dequeue_all(Dequeued& newest) noexcept {
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    v4l2_buffer buffer = mapped_buffer(0);
    const int result = calls_->control(file_, VIDIOC_DQBUF, &buffer);
    if (result == -EAGAIN) break;
    if (result == -EIO) {  // the driver lost a frame; the next may be good
      ++counts_.corrupt;
      break;
    }
    if (result < 0 || buffer.index >= buffers_.size()) {
      broken_ = true;
      break;
    }
    const int index = static_cast<int>(buffer.index);
    int back = index;
    if (std::uint64_t* const refused = objection(buffer)) {
      ++*refused;
    } else {
      back = std::exchange(newest.buffer, index);
      newest.sequence = buffer.sequence;
      newest.t_exposure = mid_exposure(buffer);
      if (back != kNone) ++counts_.overtaken;
    }
    if (back != kNone) queue(back);
  }
  return newest.buffer != kNone && !broken_;
}

std::uint64_t* V4l2Camera::objection(const v4l2_buffer& buffer) noexcept {
  if ((buffer.flags & V4L2_BUF_FLAG_ERROR) != 0) return &counts_.corrupt;
  if (buffer.bytesused < bytes_needed()) return &counts_.wrong_size;
  const std::int64_t now_ns = monotonic_now().ns;
  const std::int64_t oldest_ns = now_ns - std::chrono::nanoseconds{options_.max_age}.count();
  if (is_monotonic(buffer) && stamp_ns(buffer) <= now_ns && stamp_ns(buffer) >= oldest_ns) return nullptr;
  wrong_stamp_ns_ = stamp_ns(buffer);
  return &counts_.wrong_stamp;
}

Timestamp V4l2Camera::mid_exposure(const v4l2_buffer& buffer) const noexcept {
  const bool at_start = (buffer.flags & V4L2_BUF_FLAG_TSTAMP_SRC_MASK) == V4L2_BUF_FLAG_TSTAMP_SRC_SOE;
  const std::int64_t half = exposure_ns_ / 2;
  // A driver that marks the readout as the start would date a long exposure into the future.
  if (at_start) return {std::min(stamp_ns(buffer) + half, monotonic_now().ns)};
  return {stamp_ns(buffer) - std::chrono::nanoseconds{options_.readout}.count() - half};
}

void V4l2Camera::queue(int index) noexcept {
  v4l2_buffer buffer = mapped_buffer(index);
  // A buffer that cannot be queued is lost; without all its buffers the capture would limp until it starves.
  if (calls_->control(file_, VIDIOC_QBUF, &buffer) < 0) broken_ = true;
}

}  // namespace articam::hal
