#include "host_sim/report/control_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "host_sim/report/report_tables.hpp"

namespace articam::sim {

std::string control_csv(std::span<const ControlSample> samples) {
  std::string text = "t_s,target,position,told,hand_vx,hand_vy,hand_vz,pull_n\n";
  for (const ControlSample& s : samples) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", s.t_s, s.target, s.position, s.told,
                   s.hand_velocity.x(), s.hand_velocity.y(), s.hand_velocity.z(), s.pull);
  }
  return text;
}

std::string feedback_text(const RunRecord& run, std::span<const FeedbackRun> feedbacks) {
  const std::string_view unit = pulled_unit(run);
  const auto heading = [](std::string_view first, std::string_view in, const std::array<std::string_view, 5>& of,
                          std::string_view jerk) {
    return fmt::format("{:<19} {:>6} {:>6} {:>7} {:>7} {:>7} {:>11} {:>7}\n", first, in, of[0], of[1], of[2], of[3],
                       of[4], jerk);
  };
  std::string text = "                              told - true     at rest - target              hand\n";
  text += heading("feedback   settled", "in", {"RMS", "peak", "RMS", "peak", "overshoot"}, "jerk");
  text += heading("", "s", {unit, unit, unit, unit, unit}, "m/s^3");
  for (const FeedbackRun& f : feedbacks) {
    const PullMetrics& m = f.metrics;
    text += f.samples.empty() ? fmt::format("{:<10} knows no joint that turns\n", f.feedback)
                              : fmt::format(
                                    "{:<10} {:>2} of {:>2} {:>6.2f} {:>6.3f} {:>7.3f} {:>7.3f} {:>7.3f} {:>11.3f} "
                                    "{:>7.2f}\n",
                                    f.feedback, m.settled, m.commands, m.settling_s, m.told_rms, m.told_peak,
                                    m.error_rms, m.error_peak, m.overshoot, m.jerk_rms);
  }
  return text;
}

}  // namespace articam::sim
