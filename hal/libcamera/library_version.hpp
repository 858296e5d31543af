#pragma once
/// @file  All that differs between the releases of libcamera, 0.0.3 to 0.7, as far as we use them.

#include "hal/libcamera/capture_device.hpp"

namespace libcamera {
class ControlInfoMap;
class ControlList;
struct FrameMetadata;
}  // namespace libcamera

namespace articam::hal {

/// What the requests are to carry so that the camera does what `controls` says.
/// Before 0.5 one switch turns automatic exposure and gain on and off together, so fixing one of them leaves the other
/// automatic only where the camera's algorithm accepts that. Since 0.5 each has its own mode.
libcamera::ControlList control_list(const libcamera::ControlInfoMap& known, const Controls& controls);

/// Since 0.5.2 a frame of the time before exposure has settled is marked; earlier releases call it corrupt or good.
CompletedBuffer::Health health_of(const libcamera::FrameMetadata& metadata) noexcept;

}  // namespace articam::hal
