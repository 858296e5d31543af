#pragma once
/// @file  The seam to libcamera: what LibcameraCamera asks of the library. A test puts a scripted device here.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/timestamp.hpp"

namespace articam::hal {

/// One buffer that came back, before anybody has read a pixel of it.
struct CompletedBuffer {
  enum class Health : std::uint8_t {
    good,
    starting_up,  ///< complete, but the camera's algorithms have not settled
    corrupt,
    cancelled
  };
  int buffer{};
  Health health{};
  std::uint32_t sequence{};
  Timestamp stamp{};           ///< the library's sensor time stamp
  std::int64_t exposure_ns{};  ///< 0 where the camera does not tell
  std::size_t bytes_used{};    ///< of the first plane
};

/// Called on a thread of the library, one call at a time.
class CaptureEvents {
 public:
  virtual void completed(const CompletedBuffer& buffer) noexcept = 0;
  virtual void disconnected() noexcept = 0;

 protected:
  ~CaptureEvents() = default;
};

struct ControlRange {
  double min{}, max{};
};

/// What an opened camera can do.
struct Abilities {
  std::vector<std::uint32_t> formats;                        ///< fourcc, of the video stream
  std::optional<ControlRange> exposure_us, gain, period_us;  ///< absent: the camera decides
};

/// What was configured, and the first plane of each of its buffers, mapped and readable until close().
struct Stream {
  std::uint32_t format{};
  int width_px{}, height_px{};
  std::size_t stride_bytes{};
  std::vector<std::span<const std::uint8_t>> buffers;
};

struct Controls {
  std::optional<std::int32_t> exposure_us;  ///< else automatic
  std::optional<float> gain;                ///< factor; else automatic
  std::optional<std::int64_t> period_us;    ///< else the camera's own
};

/// Called in the order written. What is not noexcept throws StartProblem (or what the library throws) on failure.
class CaptureDevice {
 public:
  virtual ~CaptureDevice() = default;
  virtual std::vector<std::string> cameras() = 0;  ///< ids of those connected now
  virtual Abilities open(const std::string& id) = 0;
  virtual Stream configure(std::uint32_t format, int width_px, int height_px, int buffers) = 0;
  virtual void start(const Controls& controls, CaptureEvents& events) = 0;  ///< with every buffer queued
  /// The processor's view of a buffer is made current, and given up. One at a time; neither takes heap or lock.
  virtual void begin_reading(int buffer) noexcept = 0;
  virtual void end_reading(int buffer) noexcept = 0;
  /// Any thread, but not the loop's: the library locks and allocates. False: the buffer is lost.
  virtual bool queue(int buffer) noexcept = 0;
  /// Gives everything back; allowed in any state. No event comes after it has returned.
  virtual void close() noexcept = 0;
};

}  // namespace articam::hal
