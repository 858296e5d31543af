#pragma once
/// @file  A camera of libcamera as the loop sees it. This header does not include the library.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/capture/capture_counts.hpp"
#include "hal/capture/exposure_stamp.hpp"
#include "hal/capture/luma_layout.hpp"
#include "hal/libcamera/capture_device.hpp"
#include "hal/libcamera/newest_frame.hpp"
#include "hal/libcamera/requeuer.hpp"
#include "hal/ports/camera_port.hpp"

namespace articam::hal {

struct LibcameraOptions {
  std::string camera{};  ///< its id, or its place in the list as a number; empty: the first one
  int width_px{}, height_px{};
  std::chrono::microseconds period{};                   ///< of the frames; 0: the camera's own
  std::optional<std::chrono::microseconds> exposure{};  ///< none: automatic
  std::optional<double> gain{};                         ///< factor, at least 1; none: automatic
  std::optional<StampMarks> stamp{};  ///< none: readout_start in a frame that tells its exposure, else exposure_start
  std::chrono::milliseconds max_age{1000};  ///< a stamp older than this, or of the future, is of another clock
  std::chrono::milliseconds first_frame_wait{5000};
  int buffers{4};
};

/// Lends frames in place where the camera gives a plane of luma. Where it does not, each frame is copied into one image
/// of its own, and description() says so. One frame is lent at a time.
///
/// Frames  t_exposure is mid-exposure of the first row, on CLOCK_MONOTONIC, where the camera tells its exposure time
///         or one was asked for; the sensor's time stamp itself where neither is so. It rises from frame to frame.
/// Stamps  libcamera documents controls::SensorTimestamp as "the time when the first row of the image sensor active
///         array is exposed", but its pipelines pass on the kernel's stamp. A receiver of CSI sees the first row when
///         it is read out; a USB camera names the start of its exposure. Only pipelines that steer a sensor on CSI tell
///         the exposure of each frame, and that is how they are known apart here.
/// Heap    used in start and stop only; libcamera itself uses it while it captures, in its own thread and in one of
///         ours, never in the loop's.
class LibcameraCamera final : private CaptureEvents {
 public:
  explicit LibcameraCamera(LibcameraOptions options);  ///< on the real library
  LibcameraCamera(LibcameraOptions options, std::unique_ptr<CaptureDevice> device);
  ~LibcameraCamera();

  /// Waits for the first good frame, to hold its stamp against the clock. Errors: no_device (none, or not this one),
  /// bad_argument (the camera cannot do what the options ask), io_error, timeout (no frame came).
  Status start() noexcept;
  void stop() noexcept;
  Status acquire(Frame& out, std::chrono::milliseconds wait) noexcept;
  void release(Frame& frame) noexcept;

  std::string_view problem() const noexcept { return problem_; }            ///< why the last call was not ok
  const std::string& description() const noexcept { return description_; }  ///< of the running capture, for a log
  const std::string& warning() const noexcept { return warning_; }  ///< what the camera does otherwise; or empty
  CaptureCounts counts() const noexcept;

 private:
  enum Counted {
    kOvertaken,
    kStartingUp,
    kCorrupt,
    kCancelled,
    kWrongSize,
    kWrongStamp,
    kOutOfOrder,
    kCopied,
    kNumCounted
  };
  enum class Ending : std::uint8_t { none, unplugged, buffer_lost, foreign_clock };  ///< only a new start helps
  struct Stamped {
    std::uint32_t sequence{};
    Timestamp t_exposure{};
  };

  void completed(const CompletedBuffer& buffer) noexcept override;
  void disconnected() noexcept override;

  void open_and_start();
  void check_stream() const;
  void describe(const std::string& id, const Controls& controls);
  void await_first_frame();
  std::optional<Counted> objection(const CompletedBuffer& buffer, Timestamp now) const noexcept;
  Timestamp t_exposure(const CompletedBuffer& buffer, Timestamp now) const noexcept;
  void give_back() noexcept;  ///< what is lent
  void queue(int buffer) noexcept;
  void end(Ending why) noexcept;
  static std::string_view why(Ending ending) noexcept;
  void count(Counted what) noexcept { counts_[what].fetch_add(1, std::memory_order_relaxed); }

  LibcameraOptions options_;
  std::unique_ptr<CaptureDevice> device_;
  const LumaLayout* layout_{};
  Stream stream_;
  std::vector<std::uint8_t> copy_;  ///< the image, where luma cannot be lent in place
  std::vector<Stamped> stamped_;    ///< by buffer; written before its post, read after its take
  NewestFrame newest_;
  std::atomic<bool> capturing_{false};
  std::atomic<Ending> ending_{Ending::none};
  bool any_good_{false};                        ///< since the start; the library's thread's, as the next
  Timestamp t_newest_{};                        ///< of the good frames
  std::atomic<std::int64_t> wrong_stamp_ns_{};  ///< that ended the capture
  std::array<std::atomic<std::uint64_t>, kNumCounted> counts_{};
  int lent_{NewestFrame::kNone};
  std::string start_problem_;
  std::string_view problem_;
  std::string description_, warning_;
  Requeuer requeuer_;  ///< of what the loop gives back
};
static_assert(CameraPort<LibcameraCamera>);

}  // namespace articam::hal
