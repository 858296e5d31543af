/// @file  articam-loop: the firmware's whole loop on a processor without an operating system.
///
/// Given a folder of frames (see SemihostingCamera), it prints one line a frame and ends with 0 when the object was
/// tracked in most of them. All memory is static.

#include <algorithm>
#include <array>
#include <string_view>

#include "core/tracker/tracker.hpp"
#include "hal/baremetal/console_link.hpp"
#include "hal/baremetal/fault.hpp"
#include "hal/baremetal/semihosting_camera.hpp"
#include "hal/run_loop.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"

namespace articam {

using Model = models::PrinterDrawer;
extern template class tracker::Tracker<Model, float>;  // from libarticam_firmware.a

namespace {

/// Of the rendered recordings: 640 x 480, f = 525 px, no distortion.
constexpr CameraParameters recorded_with() noexcept {
  CameraParameters camera;
  camera.width_px = 640, camera.height_px = 480;
  camera.fx_px = camera.fy_px = 525;
  camera.cx_px = 319.5, camera.cy_px = 239.5;
  return camera;
}

using Tracker = tracker::Tracker<Model, float>;
using Link = hal::ConsoleLink<Tracker::EstimateType>;

std::array<char, 256> command_line;
/// The words after the program's own name.
std::string_view folder() noexcept {
  std::string_view words = hal::semihosting::command_line(command_line);
  words.remove_prefix(std::min(words.find(' '), words.size()));
  words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
  return words;
}

hal::SemihostingCamera camera{folder(), 30};
Tracker tracker{recorded_with()};
Link link;
hal::RunLoop loop{camera, camera, link, tracker, {.period = std::chrono::nanoseconds{33'333'333}}};

}  // namespace
}  // namespace articam

int main() {
  using namespace articam;
  if (loop.start() != Status::ok) hal::stop_with_fault("the camera does not start");
  while (loop.run_once() != hal::Tick::ended) {
  }
  const hal::Counters& counters = loop.counters();
  hal::Line line;
  line << "frames " << counters.frames << " tracked " << link.tracked() << " camera_errors " << counters.camera_errors
       << '\n';
  hal::semihosting::write(line.text());
  return counters.frames > 0 && 2 * link.tracked() > counters.frames ? 0 : 1;
}
