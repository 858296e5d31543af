#include "hal/v4l2/device_settings.hpp"

#include <linux/videodev2.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "hal/capture/start_problem.hpp"

namespace articam::hal::v4l2 {
namespace {

[[noreturn]] void refuse(std::string reason) { throw StartProblem{Status::bad_argument, std::move(reason)}; }

std::string size_text(std::uint32_t width_px, std::uint32_t height_px) {
  return std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels";
}

void check_capabilities(const Device& device) {
  v4l2_capability capability{};
  check(device.control(VIDIOC_QUERYCAP, &capability), "be asked what it can do");
  const bool own = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0;
  const std::uint32_t can = own ? capability.device_caps : capability.capabilities;
  if ((can & V4L2_CAP_VIDEO_CAPTURE_MPLANE) != 0) refuse("it is multi-planar: use libcamera for this device");
  if ((can & V4L2_CAP_VIDEO_CAPTURE) == 0) refuse("it does not capture video (metadata or output node?)");
  if ((can & V4L2_CAP_STREAMING) == 0) refuse("it does not stream into mapped buffers");
}

std::vector<std::uint32_t> offered_formats(const Device& device) {
  constexpr std::uint32_t kMostFormats = 64;  // a driver that never ends its list must not hang us
  std::vector<std::uint32_t> offered;
  for (std::uint32_t i = 0; i < kMostFormats; ++i) {
    v4l2_fmtdesc format{};
    format.index = i;
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (device.control(VIDIOC_ENUM_FMT, &format) < 0) break;
    offered.push_back(format.pixelformat);
  }
  return offered;
}

/// Sets the format. What is wrong with the one that the device then takes, or nothing.
std::string try_format(const Device& device, const LumaLayout& layout, const V4l2Options& options,
                       std::size_t& stride_bytes) {
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  format.fmt.pix.width = static_cast<std::uint32_t>(options.width_px);
  format.fmt.pix.height = static_cast<std::uint32_t>(options.height_px);
  format.fmt.pix.pixelformat = layout.format;
  format.fmt.pix.field = V4L2_FIELD_NONE;
  const v4l2_pix_format wanted = format.fmt.pix;
  check(device.control(VIDIOC_S_FMT, &format), "be given its format");
  const v4l2_pix_format& got = format.fmt.pix;
  if (got.width != wanted.width || got.height != wanted.height) {
    return "it gives " + size_text(got.width, got.height) + ", the camera file says " +
           size_text(wanted.width, wanted.height);
  }
  if (got.pixelformat != wanted.pixelformat) return "it does not keep to the format that it offered";
  if (got.field != V4L2_FIELD_NONE) return "its image is interlaced";
  if (got.bytesperline < got.width * static_cast<std::uint32_t>(layout.step)) {
    return "its rows are " + std::to_string(got.bytesperline) + " bytes, too short for their pixels";
  }
  stride_bytes = got.bytesperline;
  return {};
}

/// A device may give some of its formats in some of its sizes only.
void set_format(const Device& device, const V4l2Options& options, Settled& settled) {
  std::vector<std::uint32_t> offered = offered_formats(device);
  std::string first_objection;
  while (const LumaLayout* const layout = preferred_layout(offered)) {
    const std::string objection = try_format(device, *layout, options, settled.stride_bytes);
    settled.layout = layout;
    if (objection.empty()) return;
    if (first_objection.empty()) first_objection = objection;
    std::erase(offered, layout->format);
  }
  if (!first_objection.empty()) refuse(first_objection);
  refuse("it offers no 8-bit format with luma or green (GREY, NV12, YUV420, YUYV, RGB24 or alike)");
}

/// A warning where the device keeps a frame duration of its own.
std::string set_period(const Device& device, const V4l2Options& options) {
  const std::string own = "the camera keeps its own frame duration";
  v4l2_streamparm parameters{};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (device.control(VIDIOC_G_PARM, &parameters) < 0) return own;
  if ((parameters.parm.capture.capability & V4L2_CAP_TIMEPERFRAME) == 0) return own;
  parameters.parm.capture.timeperframe = {static_cast<std::uint32_t>(options.period.count()), 1'000'000};
  check(device.control(VIDIOC_S_PARM, &parameters), "be given its frame duration");
  const v4l2_fract got = parameters.parm.capture.timeperframe;
  const double got_us = got.denominator == 0 ? 0 : 1e6 * got.numerator / got.denominator;
  const double off = got_us / static_cast<double>(options.period.count()) - 1;
  if (off > -0.05 && off < 0.05) return {};  // 29.97 frames a second pass for 30, 25 do not
  return own + ", " + std::to_string(std::lround(got_us)) + " us, instead of " +
         std::to_string(options.period.count()) + " us";
}

bool set_control(const Device& device, std::uint32_t id, int value) {
  v4l2_control control{id, value};
  return device.control(VIDIOC_S_CTRL, &control) >= 0;
}

bool has_control(const Device& device, std::uint32_t id, v4l2_queryctrl& out) {
  out = {};
  out.id = id;
  return device.control(VIDIOC_QUERYCTRL, &out) >= 0 && (out.flags & V4L2_CTRL_FLAG_DISABLED) == 0;
}

/// Sets and reads back: drivers round.
int fix_control(const Device& device, const v4l2_queryctrl& range, int value, const std::string& what) {
  if (value < range.minimum || value > range.maximum) {
    refuse(what + " must be " + std::to_string(range.minimum) + " to " + std::to_string(range.maximum) + ", not " +
           std::to_string(value));
  }
  v4l2_control control{range.id, value};
  check(device.control(VIDIOC_S_CTRL, &control), "be given its " + what);
  check(device.control(VIDIOC_G_CTRL, &control), "be asked for its " + what);
  return control.value;
}

/// ns; 0 when it is automatic.
std::int64_t set_exposure(const Device& device, const V4l2Options& options) {
  if (!options.exposure) {  // full automatic where there is such a thing, else of the time alone
    if (!set_control(device, V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_AUTO)) {
      (void)set_control(device, V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY);
    }
    return 0;
  }
  (void)set_control(device, V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL);  // not all have both
  v4l2_queryctrl range;
  if (!has_control(device, V4L2_CID_EXPOSURE_ABSOLUTE, range)) {
    refuse("it cannot fix its exposure; leave it automatic");
  }
  constexpr std::int64_t kUnit_us = 100;
  const auto units = static_cast<int>((options.exposure->count() + kUnit_us / 2) / kUnit_us);
  return fix_control(device, range, units, "exposure, in 100 us,") * kUnit_us * 1000;
}

void set_gain(const Device& device, const V4l2Options& options) {
  (void)set_control(device, V4L2_CID_AUTOGAIN, options.gain ? 0 : 1);  // not all have it
  if (!options.gain) return;
  v4l2_queryctrl range;
  if (!has_control(device, V4L2_CID_GAIN, range) && !has_control(device, V4L2_CID_ANALOGUE_GAIN, range)) {
    refuse("it cannot fix its gain; leave it automatic");
  }
  (void)fix_control(device, range, *options.gain, "gain");
}

}  // namespace

void check(int result, const std::string& what) {
  if (result >= 0) return;
  const bool gone = result == -ENODEV || result == -ENXIO || result == -ENOENT;
  std::string reason = "it could not " + what + ": " + std::strerror(-result);
  if (result == -EBUSY) reason += " (does another program use it?)";
  if (result == -EACCES) reason += " (is the user in the group video?)";
  throw StartProblem{gone ? Status::no_device : Status::io_error, std::move(reason)};
}

Settled settle(const Device& device, const V4l2Options& options) {
  check_capabilities(device);
  Settled settled;
  set_format(device, options, settled);
  if (options.period.count() > 0) settled.warning = set_period(device, options);
  settled.exposure_ns = set_exposure(device, options);
  // Automatic exposure of USB cameras may take longer frames in the dark, unless told that the rate goes first.
  if (options.period.count() > 0) (void)set_control(device, V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0);
  set_gain(device, options);
  return settled;
}

}  // namespace articam::hal::v4l2
