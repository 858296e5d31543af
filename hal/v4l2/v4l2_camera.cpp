#include "hal/v4l2/v4l2_camera.hpp"

#include <linux/videodev2.h>
#include <poll.h>

#include <cassert>
#include <cerrno>
#include <exception>
#include <utility>

#include "hal/capture/exposure_stamp.hpp"
#include "hal/capture/start_problem.hpp"
#include "hal/posix/monotonic_clock.hpp"
#include "hal/v4l2/device_settings.hpp"

namespace articam::hal {
namespace {

v4l2_buffer mapped_buffer(int index) noexcept {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = static_cast<std::uint32_t>(index);
  return buffer;
}

Timestamp stamp_of(const v4l2_buffer& buffer) noexcept {
  return {static_cast<std::int64_t>(buffer.timestamp.tv_sec) * 1'000'000'000 +
          static_cast<std::int64_t>(buffer.timestamp.tv_usec) * 1000};
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
    } catch (const StartProblem& problem) {
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
    throw StartProblem{Status::bad_argument, "the image size is beyond what this program is built for"};
  }
  const int file = calls_->open(options_.device.c_str());
  v4l2::check(file, "be opened");
  file_ = file;
  const v4l2::Settled settled = v4l2::settle({*calls_, file_}, options_);
  layout_ = settled.layout;
  stride_bytes_ = settled.stride_bytes;
  exposure_ns_ = settled.exposure_ns;
  warning_ = settled.warning;
  t_newest_ = {};
  if (!layout_->in_place()) copy_.resize(static_cast<std::size_t>(options_.width_px * options_.height_px));
  map_buffers();
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2::check(calls_->control(file_, VIDIOC_STREAMON, &type), "start the capture");
  description_ = options_.device + ": " + std::to_string(options_.width_px) + " x " +
                 std::to_string(options_.height_px) + ", stride " + std::to_string(stride_bytes_) + ", " +
                 std::to_string(buffers_.size()) + " buffers, " + std::string{layout_->how_lent()};
}

void V4l2Camera::map_buffers() {
  v4l2_requestbuffers request{};
  request.count = static_cast<std::uint32_t>(options_.buffers);
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  v4l2::check(calls_->control(file_, VIDIOC_REQBUFS, &request), "make its buffers");
  if (request.count < 2) throw StartProblem{Status::io_error, "it gives fewer than two buffers"};
  buffers_.reserve(request.count);
  for (int i = 0; i < static_cast<int>(request.count); ++i) {
    v4l2_buffer buffer = mapped_buffer(i);
    v4l2::check(calls_->control(file_, VIDIOC_QUERYBUF, &buffer), "be asked for its buffers");
    if (!is_monotonic(buffer)) {
      throw StartProblem{Status::bad_argument, "its time stamps are not of CLOCK_MONOTONIC"};
    }
    if (buffer.length < image_bytes()) {
      throw StartProblem{Status::bad_argument, "its buffers are too short for the image"};
    }
    void* const data = calls_->map(file_, buffer.length, buffer.m.offset);
    if (data == nullptr) throw StartProblem{Status::io_error, "its buffers could not be mapped"};
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
    throw StartProblem{Status::bad_argument, "its time stamps, " + std::to_string(wrong_stamp_ns_) +
                                                 " ns, are not within " + std::to_string(options_.max_age.count()) +
                                                 " ms before CLOCK_MONOTONIC"};
  }
  throw StartProblem{status, "after its start: " + std::string{problem_}};
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

std::size_t V4l2Camera::image_bytes() const noexcept {
  return bytes_needed(*layout_, options_.width_px, options_.height_px, stride_bytes_);
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
  copy_luma(*layout_, data, stride_bytes_, options_.width_px, options_.height_px, copy_.data());
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
  const std::int64_t deadline_ns = MonotonicClock{}.now().ns + std::chrono::nanoseconds{wait}.count();
  while (!broken_) {
    if (dequeue_all(newest)) return Status::ok;
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(std::chrono::nanoseconds{deadline_ns - MonotonicClock{}.now().ns});
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
    const Timestamp now = MonotonicClock{}.now();
    if (std::uint64_t* const refused = objection(buffer, now)) {
      ++*refused;
    } else {
      back = std::exchange(newest.buffer, index);
      newest.sequence = buffer.sequence;
      newest.t_exposure = t_newest_ = t_exposure(buffer, now);
      if (back != kNone) ++counts_.overtaken;
    }
    if (back != kNone) queue(back);
  }
  return newest.buffer != kNone && !broken_;
}

std::uint64_t* V4l2Camera::objection(const v4l2_buffer& buffer, Timestamp now) noexcept {
  if ((buffer.flags & V4L2_BUF_FLAG_ERROR) != 0) return &counts_.corrupt;
  if (buffer.bytesused < image_bytes()) return &counts_.wrong_size;
  if (!is_monotonic(buffer) || !is_of_this_clock(stamp_of(buffer), now, options_.max_age)) {
    wrong_stamp_ns_ = stamp_of(buffer).ns;
    return &counts_.wrong_stamp;
  }
  return t_exposure(buffer, now) <= t_newest_ ? &counts_.out_of_order : nullptr;
}

Timestamp V4l2Camera::t_exposure(const v4l2_buffer& buffer, Timestamp now) const noexcept {
  const bool at_start = (buffer.flags & V4L2_BUF_FLAG_TSTAMP_SRC_MASK) == V4L2_BUF_FLAG_TSTAMP_SRC_SOE;
  const StampMarks marks = at_start ? StampMarks::exposure_start : StampMarks::readout_end;
  return mid_exposure(stamp_of(buffer), marks, std::chrono::nanoseconds{exposure_ns_}, options_.readout, now);
}

void V4l2Camera::queue(int index) noexcept {
  v4l2_buffer buffer = mapped_buffer(index);
  // A buffer that cannot be queued is lost; without all its buffers the capture would limp until it starves.
  if (calls_->control(file_, VIDIOC_QBUF, &buffer) < 0) broken_ = true;
}

}  // namespace articam::hal
