#pragma once
/// @file  What the loop asks of a camera, on the target and in the simulator alike.

#include <chrono>
#include <concepts>
#include <cstdint>

#include "core/status.hpp"
#include "core/timestamp.hpp"
#include "core/vision/image_view.hpp"

namespace articam::hal {

/// A frame lent by a camera. `pixels` stays valid until release().
struct Frame {
  ImageView pixels;          ///< 8-bit grey, row-major
  Timestamp t_exposure{};    ///< mid-exposure, on the ClockPort
  std::uint32_t sequence{};  ///< a gap means a dropped frame
};

///   start    may allocate, and take its time; no_device when there is no camera. Called before the loop, and again
///            after stop().
///   stop     ends the capture and forgets its frames; allowed in any state.
///   acquire  blocks up to `wait`; what is not ok leaves `out` untouched: timeout, end_of_stream, io_error (a frame
///            was bad, the next may be good), no_device (unplugged, or a capture that only a new start can revive).
///   release  gives the frame back; every acquire has exactly one release, before stop().
template <class C>
concept CameraPort = requires(C camera, Frame& out, std::chrono::milliseconds wait) {
  { camera.start() }
  noexcept->std::same_as<Status>;
  { camera.stop() }
  noexcept->std::same_as<void>;
  { camera.acquire(out, wait) }
  noexcept->std::same_as<Status>;
  { camera.release(out) }
  noexcept->std::same_as<void>;
};

}  // namespace articam::hal
