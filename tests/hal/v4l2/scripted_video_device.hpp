#pragma once
/// @file  A kernel video device that does what a test says, at the system calls of hal/v4l2.

#include <linux/videodev2.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <functional>
#include <map>
#include <optional>
#include <thread>
#include <vector>

#include "hal/posix/monotonic_clock.hpp"
#include "hal/v4l2/video_calls.hpp"

namespace articam::test {

class ScriptedVideoDevice final : public hal::v4l2::VideoCalls {
 public:
  static constexpr int kBuffers = 4;
  struct Setting {
    int min{}, max{}, value{};
  };

  std::uint32_t capabilities{V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING};
  std::vector<std::uint32_t> formats{V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_GREY};
  std::function<void(v4l2_pix_format&)> bend_format = [](v4l2_pix_format&) {};  ///< after the device's own answer
  std::function<void()> on_stream = [this] { complete(0); };                    ///< the first frame
  std::map<std::uint32_t, Setting> settings;                                    ///< by V4L2_CID_*
  v4l2_fract period{1, 25};
  std::optional<v4l2_fract> nearest_period;  ///< what it makes of any period
  bool period_can_be_set{false}, takes_buffers{true};
  std::uint32_t stamp_flags{V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | V4L2_BUF_FLAG_TSTAMP_SRC_SOE};
  std::size_t buffer_length{};  ///< 0: as long as the image needs
  int open_result{3}, format_result{0};
  bool unplugged{false};

  std::uint32_t format{};
  std::size_t image_bytes{};
  std::vector<int> queued;
  int maps{}, unmaps{}, closes{};
  std::array<std::vector<std::uint8_t>, kBuffers> memory;

  /// The next free buffer as it comes back; false when the device has none to write into.
  bool complete(std::uint32_t sequence, const std::function<void(v4l2_buffer&)>& bend = {}) {
    if (queued.empty()) return false;
    v4l2_buffer buffer = describe(queued.front());
    queued.erase(queued.begin());
    buffer.bytesused = static_cast<std::uint32_t>(image_bytes);
    buffer.sequence = sequence;
    set_stamp(buffer, next_microsecond_ns());
    if (bend) bend(buffer);
    ready_.push_back(buffer);
    return true;
  }

  static void set_stamp(v4l2_buffer& buffer, std::int64_t ns) {
    buffer.timestamp.tv_sec = static_cast<decltype(buffer.timestamp.tv_sec)>(ns / 1'000'000'000);
    buffer.timestamp.tv_usec = static_cast<decltype(buffer.timestamp.tv_usec)>(ns % 1'000'000'000 / 1000);
  }

  int open(const char*) noexcept override { return unplugged ? -ENOENT : open_result; }
  void close(int) noexcept override {
    ++closes;
    queued.clear();
    ready_.clear();
  }
  void* map(int, std::size_t length, std::size_t offset) noexcept override {
    ++maps;
    memory[offset].assign(length, 100);
    return memory[offset].data();
  }
  void unmap(void*, std::size_t) noexcept override { ++unmaps; }
  int wait(int, std::chrono::milliseconds at_most) noexcept override {
    if (unplugged) return POLLERR;
    if (!ready_.empty()) return POLLIN;
    std::this_thread::sleep_for(at_most);
    return 0;
  }

  int control(int, unsigned long request, void* argument) noexcept override {
    if (unplugged) return -ENODEV;
    switch (request) {
      case VIDIOC_QUERYCAP:
        static_cast<v4l2_capability*>(argument)->capabilities = capabilities;
        return 0;
      case VIDIOC_ENUM_FMT:
        return enumerate(*static_cast<v4l2_fmtdesc*>(argument));
      case VIDIOC_S_FMT:
        return set_format(static_cast<v4l2_format*>(argument)->fmt.pix);
      case VIDIOC_G_PARM:
      case VIDIOC_S_PARM:
        return set_period(static_cast<v4l2_streamparm*>(argument)->parm.capture, request == VIDIOC_S_PARM);
      case VIDIOC_QUERYCTRL:
        return query(*static_cast<v4l2_queryctrl*>(argument));
      case VIDIOC_S_CTRL:
      case VIDIOC_G_CTRL:
        return set_or_get(*static_cast<v4l2_control*>(argument), request == VIDIOC_S_CTRL);
      default:
        return stream(request, argument);
    }
  }

 private:
  /// V4L2 counts microseconds, and no camera takes two frames in one.
  std::int64_t next_microsecond_ns() noexcept {
    const std::int64_t last_us = last_stamp_us_;
    while (last_stamp_us_ == last_us) last_stamp_us_ = hal::MonotonicClock{}.now().ns / 1000;
    return last_stamp_us_ * 1000;
  }

  int enumerate(v4l2_fmtdesc& out) const noexcept {
    if (out.index >= formats.size()) return -EINVAL;
    out.pixelformat = formats[out.index];
    return 0;
  }

  int set_format(v4l2_pix_format& pix) noexcept {
    const bool interleaved = pix.pixelformat == V4L2_PIX_FMT_YUYV || pix.pixelformat == V4L2_PIX_FMT_UYVY;
    pix.bytesperline = pix.width * (interleaved ? 2 : 1) + 16;
    if (pix.pixelformat == V4L2_PIX_FMT_RGB24) pix.bytesperline = pix.width * 3;
    format = pix.pixelformat;
    image_bytes = std::size_t{pix.bytesperline} * pix.height;
    queued.reserve(kBuffers);
    ready_.reserve(kBuffers);
    bend_format(pix);
    return format_result;
  }

  int set_period(v4l2_captureparm& capture, bool set) noexcept {
    capture.capability = period_can_be_set ? V4L2_CAP_TIMEPERFRAME : 0;
    if (set) period = nearest_period.value_or(capture.timeperframe);
    capture.timeperframe = period;
    return 0;
  }

  int query(v4l2_queryctrl& out) const noexcept {
    const auto found = settings.find(out.id);
    if (found == settings.end()) return -EINVAL;
    out.minimum = found->second.min;
    out.maximum = found->second.max;
    return 0;
  }

  int set_or_get(v4l2_control& control, bool set) noexcept {
    const auto found = settings.find(control.id);
    if (found == settings.end()) return -EINVAL;
    if (set) found->second.value = control.value;
    control.value = found->second.value;
    return 0;
  }

  v4l2_buffer describe(int index) const noexcept {
    v4l2_buffer buffer{};
    buffer.index = static_cast<std::uint32_t>(index);
    buffer.flags = stamp_flags;
    buffer.length = static_cast<std::uint32_t>(buffer_length != 0 ? buffer_length : image_bytes);
    buffer.m.offset = buffer.index;
    return buffer;
  }

  int stream(unsigned long request, void* argument) noexcept {
    auto* const buffer = static_cast<v4l2_buffer*>(argument);
    switch (request) {
      case VIDIOC_REQBUFS:
        static_cast<v4l2_requestbuffers*>(argument)->count = kBuffers;
        return 0;
      case VIDIOC_QUERYBUF:
        *buffer = describe(static_cast<int>(buffer->index));
        return 0;
      case VIDIOC_QBUF:
        if (!takes_buffers || std::ranges::count(queued, int(buffer->index)) != 0) return -EINVAL;
        queued.push_back(static_cast<int>(buffer->index));
        return 0;
      case VIDIOC_DQBUF:
        if (ready_.empty()) return -EAGAIN;
        *buffer = ready_.front();
        ready_.erase(ready_.begin());
        return 0;
      case VIDIOC_STREAMON:
        on_stream();
        return 0;
      default:
        return request == VIDIOC_STREAMOFF ? 0 : -ENOTTY;
    }
  }

  std::vector<v4l2_buffer> ready_;
  std::int64_t last_stamp_us_{};
};

}  // namespace articam::test
