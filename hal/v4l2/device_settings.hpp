#pragma once
/// @file  What is settled with a video device before it streams.

#include <cstdint>
#include <string>

#include "hal/capture/luma_layout.hpp"
#include "hal/v4l2/v4l2_camera.hpp"

namespace articam::hal::v4l2 {

/// Throws a StartProblem with the system's words when `result` is a negated errno.
void check(int result, const std::string& what);

/// An open video device and the calls to it.
struct Device {
  VideoCalls& calls;
  int file;
  int control(unsigned long request, void* argument) const noexcept { return calls.control(file, request, argument); }
};

struct Settled {
  const LumaLayout* layout{};
  std::size_t stride_bytes{};
  std::int64_t exposure_ns{};  ///< 0 while automatic
  std::string warning;         ///< what the device does otherwise than asked; or empty
};

/// Chooses the best format that the device gives at the size asked for; sets period, exposure and gain.
/// Errors  throws StartProblem: bad_argument where the device does not do what the options ask, no_device, io_error.
Settled settle(const Device& device, const V4l2Options& options);

}  // namespace articam::hal::v4l2
