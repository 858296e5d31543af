#include "tools/listen/line_output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace articam::listen {

std::string line(const Heard& heard) {
  const wire::EstimateMessage& e = heard.estimate;
  std::string status{name(e.status)};
  if (e.reason != tracker::Reason::none) status += fmt::format(" ({})", name(e.reason));
  std::string line =
      fmt::format("{:10.3f} s  frame {:<6} {:<22}", seconds_between(heard.t_first, e.t_capture), e.frame, status);
  if (e.valid) {
    for (std::size_t j = 0; j < e.joints.size(); ++j) {
      const std::string_view unit = wire::unit(heard.model, j);
      line += fmt::format("  {} {:.5f}{}{}", wire::view(heard.model.joint_names[j]), e.joints[j],
                          unit.empty() ? "" : " ", unit);
    }
    line += fmt::format("  at {:.4f} {:.4f} {:.4f} m", e.t_cam_obj[0], e.t_cam_obj[1], e.t_cam_obj[2]);
  }
  line += fmt::format("  {} markers", e.matched);
  if (e.matched > 0) line += fmt::format(" {:.2f} px", e.rms_px);
  return line + fmt::format("  age {}{:.1f} ms", heard.times.age_is_exact ? "" : ">", 1e3 * heard.times.age_s);
}

std::string LineOutput::take(const Heard& heard) {
  const std::string text = line(heard) + '\n';
  const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  return written ? std::string{} : std::string{"standard output: "} + std::strerror(errno);
}

}  // namespace articam::listen
