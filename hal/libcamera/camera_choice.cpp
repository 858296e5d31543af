#include "hal/libcamera/camera_choice.hpp"

#include <algorithm>
#include <charconv>

namespace articam::hal {
namespace {

std::string list_of(const std::vector<std::string>& ids) {
  std::string list;
  for (std::size_t i = 0; i < ids.size(); ++i) list += "\n  " + std::to_string(i) + ": " + ids[i];
  return list;
}

void check_range(const std::string& what, double value, const std::optional<ControlRange>& range) {
  if (!range) throw StartProblem{Status::bad_argument, "this camera cannot fix its " + what + "; leave it automatic"};
  if (value >= range->min && value <= range->max) return;
  throw StartProblem{Status::bad_argument, what + " " + std::to_string(value) +
                                               " is outside what this camera can do, " + std::to_string(range->min) +
                                               " to " + std::to_string(range->max)};
}

}  // namespace

std::string choose_camera(const std::vector<std::string>& ids, const std::string& wanted) {
  if (ids.empty()) throw StartProblem{Status::no_device, "libcamera finds no camera; is it connected and enabled?"};
  if (wanted.empty()) return ids.front();
  if (std::ranges::find(ids, wanted) != ids.end()) return wanted;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (error == std::errc{} && end == wanted.data() + wanted.size() && index < ids.size()) return ids[index];
  throw StartProblem{Status::no_device, "there is no camera '" + wanted + "'; libcamera finds" + list_of(ids)};
}

Controls choose_controls(const Abilities& abilities, const LibcameraOptions& options) {
  Controls controls;
  if (options.exposure) {
    check_range("exposure in us", static_cast<double>(options.exposure->count()), abilities.exposure_us);
    controls.exposure_us = static_cast<std::int32_t>(options.exposure->count());
  }
  if (options.gain) {
    check_range("gain", *options.gain, abilities.gain);
    controls.gain = static_cast<float>(*options.gain);
  }
  if (options.period.count() > 0 && abilities.period_us) {
    check_range("frame duration in us", static_cast<double>(options.period.count()), abilities.period_us);
    controls.period_us = options.period.count();
  }
  return controls;
}

}  // namespace articam::hal
