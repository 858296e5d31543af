#include "host_sim/report/control_csv.hpp"

#include <fmt/format.h>

namespace articam::sim {

std::string control_csv(std::span<const ControlSample> samples) {
  std::string text = "t_s,target,position,told,hand_vx,hand_vy,hand_vz,pull_n\n";
  for (const ControlSample& s : samples) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", s.t_s, s.target, s.position, s.told,
                   s.hand_velocity.x(), s.hand_velocity.y(), s.hand_velocity.z(), s.pull);
  }
  return text;
}

std::string feedback_text(std::span<const FeedbackRun> feedbacks) {
  std::string text =
      "                             told - true   at rest - target              hand\n"
      "feedback   settled       in  RMS     peak    RMS     peak    overshoot   jerk\n"
      "                          s   mm       mm     mm       mm           mm  m/s^3\n";
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
