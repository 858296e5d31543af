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

///   start    may allocate; called once, before the loop.
///   acquire  blocks up to `wait`; timeout, end_of_stream and io_error leave `out` untouched.
///   release  gives the frame back; every acquire has exactly one release.
template <class C>
concept CameraPort = requires(C camera, Frame& out, std::chrono::milliseconds wait) {
  { camera.start() }
  noexcept->std::same_as<Status>;
  { camera.acquire(out, wait) }
  noexcept->std::same_as<Status>;
  { camera.release(out) }
  noexcept->std::same_as<void>;
};

}  // namespace articam::hal
