#pragma once
/// @file  A capture device of Video4Linux2 as the loop sees it, for boards without libcamera. Kernel headers alone.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/capture/capture_counts.hpp"
#include "hal/capture/luma_layout.hpp"
#include "hal/ports/camera_port.hpp"
#include "hal/v4l2/video_calls.hpp"

struct v4l2_buffer;

namespace articam::hal {

struct V4l2Options {
  std::string device{"/dev/video0"};
  int width_px{}, height_px{};
  std::chrono::microseconds period{};                   ///< of the frames; 0: the device's own
  std::optional<std::chrono::microseconds> exposure{};  ///< in steps of 100 us; none: automatic
  std::optional<int> gain{};                            ///< in the device's own units; none: automatic
  std::chrono::microseconds readout{};      ///< first to last row, for drivers that stamp the end of the frame
  std::chrono::milliseconds max_age{1000};  ///< a stamp older than this, or of the future, is of another clock
  std::chrono::milliseconds first_frame_wait{5000};
  int buffers{4};
};

/// Streams into buffers of the driver that are mapped once, and lends their luma in place; where luma lies between
/// chroma (YUYV and its like) it is copied into one image of its own, and where there is none the green of an RGB
/// format. One frame is lent at a time. Single-planar devices only.
///
/// Frames  t_exposure is mid-exposure of the first row, on CLOCK_MONOTONIC, when exposure is fixed; with automatic
///         exposure the driver does not say how long it was, and half of it is missing. It rises from frame to frame.
/// Heap    used in start and stop only.
class V4l2Camera {
 public:
  explicit V4l2Camera(V4l2Options options);
  V4l2Camera(V4l2Options options, std::unique_ptr<v4l2::VideoCalls> calls);
  ~V4l2Camera();

  /// Waits for the first good frame. Errors: no_device, bad_argument (the device cannot do what the options ask),
  /// io_error, timeout (no frame came).
  Status start() noexcept;
  void stop() noexcept;
  Status acquire(Frame& out, std::chrono::milliseconds wait) noexcept;
  void release(Frame& frame) noexcept;

  std::string_view problem() const noexcept { return problem_; }            ///< why the last call was not ok
  const std::string& description() const noexcept { return description_; }  ///< of the running capture, for a log
  const std::string& warning() const noexcept { return warning_; }  ///< what the camera does otherwise; or empty
  const CaptureCounts& counts() const noexcept { return counts_; }

 private:
  struct Buffer {
    const std::uint8_t* data{};
    std::size_t length{};
  };
  struct Dequeued {
    int buffer{kNone};
    std::uint32_t sequence{};
    Timestamp t_exposure{};
  };
  static constexpr int kNone = -1;

  void open_and_start();
  void map_buffers();
  void await_first_frame();
  std::size_t image_bytes() const noexcept;
  Status next_frame(Dequeued& newest, std::chrono::milliseconds wait) noexcept;
  bool dequeue_all(Dequeued& newest) noexcept;  ///< true: there is a newest one
  std::uint64_t* objection(const v4l2_buffer& buffer, Timestamp now) noexcept;
  Timestamp t_exposure(const v4l2_buffer& buffer, Timestamp now) const noexcept;
  void queue(int buffer) noexcept;
  Status fail(Status status, std::string_view why) noexcept { return problem_ = why, status; }

  V4l2Options options_;
  std::unique_ptr<v4l2::VideoCalls> calls_;
  int file_{kNone};
  const LumaLayout* layout_{};
  std::size_t stride_bytes_{};
  std::int64_t exposure_ns_{};  ///< 0 while automatic
  std::vector<Buffer> buffers_;
  std::vector<std::uint8_t> copy_;
  int lent_{kNone};
  bool broken_{false};  ///< only a new start can revive this capture
  CaptureCounts counts_;
  Timestamp t_newest_{};           ///< of the good frames since the start
  std::int64_t wrong_stamp_ns_{};  ///< the newest that was refused
  std::string start_problem_;
  std::string_view problem_;
  std::string description_, warning_;
};
static_assert(CameraPort<V4l2Camera>);

}  // namespace articam::hal
