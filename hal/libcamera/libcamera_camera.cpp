#include "hal/libcamera/libcamera_camera.hpp"

#include <cassert>
#include <exception>
#include <utility>

#include "hal/libcamera/camera_choice.hpp"
#include "hal/posix/monotonic_clock.hpp"

namespace articam::hal {
namespace {

std::string size_text(int width_px, int height_px) {
  return std::to_string(width_px) + " x " + std::to_string(height_px);
}

}  // namespace

LibcameraCamera::LibcameraCamera(LibcameraOptions options, std::unique_ptr<CaptureDevice> device)
    : options_{std::move(options)}, device_{std::move(device)} {}

LibcameraCamera::~LibcameraCamera() { stop(); }

Status LibcameraCamera::start() noexcept {
  stop();
  Status status = Status::ok;
  problem_ = {};
  try {
    try {
      open_and_start();
      await_first_frame();
    } catch (const StartProblem& problem) {
      status = problem.status;
      start_problem_ = problem.reason;
    } catch (const std::exception& e) {
      status = Status::io_error;
      start_problem_ = std::string{"libcamera: "} + e.what();
    }
    problem_ = start_problem_;
  } catch (...) {  // no memory even for the reason, or something that is not an exception at all
    status = Status::io_error;
    problem_ = "libcamera failed without saying why";
  }
  if (status != Status::ok) stop();
  return status;
}

void LibcameraCamera::open_and_start() {
  start_problem_.clear();
  if (options_.width_px < 1 || options_.width_px > kMaxImageWidth_px || options_.height_px < 1 ||
      options_.height_px > kMaxImageHeight_px) {
    throw StartProblem{Status::bad_argument, "an image of " + size_text(options_.width_px, options_.height_px) +
                                                 " pixels is beyond what this program is built for"};
  }
  const std::string id = choose_camera(device_->cameras(), options_.camera);
  const Abilities abilities = device_->open(id);
  const Controls controls = choose_controls(abilities, options_);
  layout_ = preferred_layout(abilities.formats);
  if (layout_ == nullptr) {
    throw StartProblem{Status::bad_argument, "camera " + id + " offers no 8-bit format with luma or green"};
  }
  stream_ = device_->configure(layout_->format, options_.width_px, options_.height_px, options_.buffers);
  check_stream();
  stamped_.assign(stream_.buffers.size(), {});
  if (!layout_->in_place()) copy_.resize(static_cast<std::size_t>(options_.width_px * options_.height_px));
  describe(id, controls);
  newest_.reset();
  ending_ = Ending::none;
  any_good_ = false;
  t_newest_ = {};
  requeuer_.start([this](int buffer) { queue(buffer); });
  capturing_ = true;
  device_->start(controls, *this);
}

void LibcameraCamera::check_stream() const {
  const auto refuse = [](const std::string& reason) { throw StartProblem{Status::bad_argument, reason}; };
  const std::string wanted = size_text(options_.width_px, options_.height_px);
  if (stream_.width_px != options_.width_px || stream_.height_px != options_.height_px) {
    refuse("the camera gives " + size_text(stream_.width_px, stream_.height_px) + " pixels, the camera file says " +
           wanted);
  }
  if (stream_.format != layout_->format) refuse("the camera does not keep to the format " + std::string{layout_->name});
  if (stream_.stride_bytes < static_cast<std::size_t>(options_.width_px * layout_->step)) {
    refuse("the camera's rows are " + std::to_string(stream_.stride_bytes) + " bytes, too short for their pixels");
  }
  if (stream_.buffers.size() < 2) refuse("the camera gives fewer than two buffers");
  if (stream_.buffers.size() > Requeuer::kMaxBuffers) refuse("the camera gives more than 32 buffers");
  for (const auto buffer : stream_.buffers) {
    if (buffer.size() < bytes_needed(*layout_, options_.width_px, options_.height_px, stream_.stride_bytes)) {
      refuse("the camera's buffers of " + std::to_string(buffer.size()) + " bytes are too short for the image");
    }
  }
}

void LibcameraCamera::describe(const std::string& id, const Controls& controls) {
  description_ = "camera " + id + ": " + std::string{layout_->name} + " " +
                 size_text(options_.width_px, options_.height_px) + ", stride " + std::to_string(stream_.stride_bytes) +
                 ", " + std::to_string(stream_.buffers.size()) + " buffers, ";
  description_ += layout_->how_lent();
  description_ += controls.exposure_us ? ", exposure " + std::to_string(*controls.exposure_us) + " us" : "";
  description_ += controls.gain ? ", gain " + std::to_string(*controls.gain) : "";
  const bool own_period = options_.period.count() > 0 && !controls.period_us;
  warning_ = own_period ? "the camera's frame duration cannot be set: it keeps its own" : "";
}

void LibcameraCamera::await_first_frame() {
  const int buffer = newest_.take(options_.first_frame_wait);
  if (buffer >= 0) return queue(buffer);
  if (buffer == NewestFrame::kNone) {
    throw StartProblem{Status::timeout, "no good frame within " + std::to_string(options_.first_frame_wait.count()) +
                                            " ms of the start"};
  }
  if (ending_ != Ending::foreign_clock) throw StartProblem{Status::no_device, std::string{why(ending_)}};
  throw StartProblem{Status::bad_argument,
                     "the first frame's time stamp, " + std::to_string(wrong_stamp_ns_.load()) + " ns, is not within " +
                         std::to_string(options_.max_age.count()) +
                         " ms before CLOCK_MONOTONIC; a machine that has slept and a driver that stamps with "
                         "CLOCK_BOOTTIME look like this"};
}

void LibcameraCamera::stop() noexcept {
  capturing_ = false;  // before close: what is cancelled by it is not queued again
  requeuer_.stop();
  device_->close();
  newest_.reset();
  lent_ = NewestFrame::kNone;
  stream_ = {};
}

Status LibcameraCamera::acquire(Frame& out, std::chrono::milliseconds wait) noexcept {
  assert(lent_ == NewestFrame::kNone && "one frame is lent at a time");
  if (!capturing_) return problem_ = "the camera is not started", Status::no_device;
  const int buffer = newest_.take(wait);
  if (buffer == NewestFrame::kNone) return problem_ = "no frame came in time", Status::timeout;
  if (buffer == NewestFrame::kClosed) return problem_ = why(ending_), Status::no_device;
  const auto i = static_cast<std::size_t>(buffer);
  const Stamped stamped = stamped_[i];
  const std::uint8_t* const pixels = stream_.buffers[i].data();
  lent_ = buffer;
  device_->begin_reading(buffer);
  if (layout_->in_place()) {
    out = {{pixels, stream_.width_px, stream_.height_px, static_cast<std::ptrdiff_t>(stream_.stride_bytes)},
           stamped.t_exposure,
           stamped.sequence};
    return Status::ok;
  }
  copy_luma(*layout_, pixels, stream_.stride_bytes, stream_.width_px, stream_.height_px, copy_.data());
  give_back();
  count(kCopied);
  out = {{copy_.data(), stream_.width_px, stream_.height_px, stream_.width_px}, stamped.t_exposure, stamped.sequence};
  return Status::ok;
}

void LibcameraCamera::release(Frame& frame) noexcept {
  frame = {};
  if (lent_ != NewestFrame::kNone) give_back();
}

void LibcameraCamera::give_back() noexcept {
  device_->end_reading(lent_);
  requeuer_.give_back(std::exchange(lent_, NewestFrame::kNone));
}

void LibcameraCamera::queue(int buffer) noexcept {
  // A buffer that cannot be queued is lost; without all its buffers the capture would limp until it starves.
  if (!device_->queue(buffer)) end(Ending::buffer_lost);
}

void LibcameraCamera::end(Ending why) noexcept {
  auto none = Ending::none;
  // The first reason is the cause. But a camera that is unplugged may refuse its buffers before that is told.
  if (!ending_.compare_exchange_strong(none, why) && why == Ending::unplugged) ending_ = why;
  newest_.close();
}

void LibcameraCamera::completed(const CompletedBuffer& buffer) noexcept {
  if (!capturing_) return;
  const Timestamp now = MonotonicClock{}.now();
  if (const auto refused = objection(buffer, now)) {
    count(*refused);
    if (*refused == kWrongStamp && !any_good_) {
      wrong_stamp_ns_ = buffer.stamp.ns;
      return end(Ending::foreign_clock);
    }
    return queue(buffer.buffer);
  }
  any_good_ = true;
  t_newest_ = t_exposure(buffer, now);
  stamped_[static_cast<std::size_t>(buffer.buffer)] = {buffer.sequence, t_newest_};
  const int overtaken = newest_.post(buffer.buffer);
  if (overtaken == NewestFrame::kNone) return;
  count(kOvertaken);
  queue(overtaken);
}

void LibcameraCamera::disconnected() noexcept { end(Ending::unplugged); }

Timestamp LibcameraCamera::t_exposure(const CompletedBuffer& buffer, Timestamp now) const noexcept {
  const bool told = buffer.exposure_ns != 0;
  const std::chrono::nanoseconds asked = options_.exposure.value_or(std::chrono::microseconds{0});
  const auto exposure = told ? std::chrono::nanoseconds{buffer.exposure_ns} : asked;
  const StampMarks marks = options_.stamp.value_or(told ? StampMarks::readout_start : StampMarks::exposure_start);
  return mid_exposure(buffer.stamp, marks, exposure, {}, now);
}

std::optional<LibcameraCamera::Counted> LibcameraCamera::objection(const CompletedBuffer& buffer,
                                                                   Timestamp now) const noexcept {
  using Health = CompletedBuffer::Health;
  if (buffer.health == Health::cancelled) return kCancelled;
  if (buffer.health == Health::corrupt) return kCorrupt;
  if (buffer.health == Health::starting_up) return kStartingUp;
  if (buffer.bytes_used < bytes_needed(*layout_, stream_.width_px, stream_.height_px, stream_.stride_bytes)) {
    return kWrongSize;
  }
  const std::chrono::nanoseconds max_age = options_.max_age;
  if (!is_of_this_clock(buffer.stamp, now, max_age)) return kWrongStamp;
  if (buffer.exposure_ns < 0 || buffer.exposure_ns > max_age.count()) return kWrongStamp;
  if (any_good_ && t_exposure(buffer, now) <= t_newest_) return kOutOfOrder;
  return std::nullopt;
}

std::string_view LibcameraCamera::why(Ending ending) noexcept {
  if (ending == Ending::buffer_lost) return "a buffer could not be given back to the camera";
  if (ending == Ending::foreign_clock) return "the time stamps are of another clock";
  return "the camera was unplugged";
}

CaptureCounts LibcameraCamera::counts() const noexcept {
  const auto of = [this](Counted what) { return counts_[what].load(std::memory_order_relaxed); };
  return {of(kOvertaken), of(kStartingUp), of(kCorrupt),    of(kCancelled),
          of(kWrongSize), of(kWrongStamp), of(kOutOfOrder), of(kCopied)};
}

}  // namespace articam::hal
