#include "hal/libcamera/library_version.hpp"

#include <libcamera/control_ids.h>
#include <libcamera/framebuffer.h>
#include <libcamera/version.h>

namespace articam::hal {

// What needs no switch: generateConfiguration takes a braced list of roles as a vector (to 0.0.5) and as an
// initializer_list (from 0.1); planes() and metadata() are bound to const auto&, whatever they return. `transform`
// (to 0.1) and `orientation` (from 0.2) keep their defaults, upright: the camera file is made from such images.

libcamera::ControlList control_list(const libcamera::ControlInfoMap& known, const Controls& controls) {
  namespace ids = libcamera::controls;
  libcamera::ControlList to{known};
#if LIBCAMERA_VERSION_MAJOR * 10000 + LIBCAMERA_VERSION_MINOR * 100 + LIBCAMERA_VERSION_PATCH >= 500
  if (known.count(ids::ExposureTimeMode.id()) != 0) {
    to.set(ids::ExposureTimeMode, controls.exposure_us ? ids::ExposureTimeModeManual : ids::ExposureTimeModeAuto);
  }
  if (known.count(ids::AnalogueGainMode.id()) != 0) {
    to.set(ids::AnalogueGainMode, controls.gain ? ids::AnalogueGainModeManual : ids::AnalogueGainModeAuto);
  }
#else
  if (known.count(ids::AeEnable.id()) != 0) to.set(ids::AeEnable, !(controls.exposure_us && controls.gain));
#endif
  if (controls.exposure_us) to.set(ids::ExposureTime, *controls.exposure_us);
  if (controls.gain) to.set(ids::AnalogueGain, *controls.gain);
  if (controls.period_us) to.set(ids::FrameDurationLimits, {*controls.period_us, *controls.period_us});
  return to;
}

CompletedBuffer::Health health_of(const libcamera::FrameMetadata& metadata) noexcept {
  using Health = CompletedBuffer::Health;
  switch (metadata.status) {
    case libcamera::FrameMetadata::FrameSuccess:
      return Health::good;
    case libcamera::FrameMetadata::FrameCancelled:
      return Health::cancelled;
#if LIBCAMERA_VERSION_MAJOR * 10000 + LIBCAMERA_VERSION_MINOR * 100 + LIBCAMERA_VERSION_PATCH >= 502
    case libcamera::FrameMetadata::FrameStartup:
      return Health::starting_up;
#endif
    case libcamera::FrameMetadata::FrameError:
      break;
  }
  return Health::corrupt;
}

}  // namespace articam::hal
