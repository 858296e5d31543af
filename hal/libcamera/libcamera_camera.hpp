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

#include "hal/libcamera/capture_device.hpp"
#include "hal/libcamera/luma_layout.hpp"
#include "hal/libcamera/newest_frame.hpp"
#include "hal/ports/camera_port.hpp"

namespace articam::hal {

/// What the sensor time stamp marks. libcamera documents controls::SensorTimestamp as "the time when the first row of
/// the image sensor active array is exposed"; most pipelines pass on the stamp of the kernel's receiver, which sees the
/// first row when it is read out.
enum class StampMarks : std::uint8_t { exposure_start, readout_start };

struct LibcameraOptions {
  std::string camera{};  ///< its id, or its place in the list as a number; empty: the first one
  int width_px{}, height_px{};
  std::chrono::microseconds period{};                   ///< of the frames; 0: the camera's own
  std::optional<std::chrono::microseconds> exposure{};  ///< none: automatic
  std::optional<double> gain{};                         ///< factor, at least 1; none: automatic
  StampMarks stamp{StampMarks::exposure_start};
  std::chrono::milliseconds max_age{1000};  ///< a stamp older than this, or of the future, is of another clock
  std::chrono::milliseconds first_frame_wait{5000};
  int buffers{4};
};

/// Lends frames in place where the camera gives a plane of luma. Where it does not, each frame is copied into one image
/// of its own, and description() says so. One frame is lent at a time.
///
/// Frames  t_exposure is mid-exposure of the first row, on CLOCK_MONOTONIC, where the camera tells its exposure time
///         or one was asked for; the sensor's time stamp itself where neither is so.
/// Heap    used in start and stop only; libcamera itself uses it also while it captures.
class LibcameraCamera final : private CaptureEvents {
 public:
  struct Counts {
    std::uint64_t overtaken{};    ///< good frames that a newer one replaced before the loop took them
    std::uint64_t starting_up{};  ///< refused: exposure had not settled
    std::uint64_t corrupt{};      ///< refused: marked so by the library
    std::uint64_t cancelled{};    ///< refused: the capture was ending
    std::uint64_t wrong_size{};   ///< refused: shorter than the image
    std::uint64_t wrong_stamp{};  ///< refused: of another clock, older than max_age or of the future
    std::uint64_t copied{};       ///< lent as a copy; see description()
  };

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
  Counts counts() const noexcept;                                           ///< since the object was made

 private:
  enum Counted { kOvertaken, kStartingUp, kCorrupt, kCancelled, kWrongSize, kWrongStamp, kCopied, kNumCounted };
  enum class Clock : std::uint8_t { unknown, agrees, differs };  ///< what the first frame showed of its stamps
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
  Timestamp mid_exposure(const CompletedBuffer& buffer) const noexcept;
  std::optional<Counted> objection(const CompletedBuffer& buffer) const noexcept;
  void give_back(int buffer) noexcept;
  void count(Counted what) noexcept { counts_[what].fetch_add(1, std::memory_order_relaxed); }

  LibcameraOptions options_;
  std::unique_ptr<CaptureDevice> device_;
  const LumaLayout* layout_{};
  Stream stream_;
  std::vector<std::uint8_t> copy_;  ///< the image, where luma cannot be lent in place
  std::vector<Stamped> stamped_;    ///< by buffer; written before its post, read after its take
  NewestFrame newest_;
  std::atomic<bool> capturing_{false};
  std::atomic<Clock> clock_{Clock::unknown};
  std::atomic<std::int64_t> wrong_stamp_ns_{};  ///< the newest that was refused
  std::array<std::atomic<std::uint64_t>, kNumCounted> counts_{};
  int lent_{NewestFrame::kNone};
  std::string start_problem_;
  std::string_view problem_;
  std::string description_;
};
static_assert(CameraPort<LibcameraCamera>);

}  // namespace articam::hal
