#include "host_sim/report/report_tables.hpp"

#include <fmt/format.h>

#include <functional>
#include <initializer_list>
#include <string_view>

namespace articam::sim {
namespace {

std::string row(std::string_view what, std::initializer_list<std::string> cells, std::string_view tag = "td") {
  std::string text = fmt::format("<tr><th scope=\"row\">{}</th>", what);
  for (const std::string& cell : cells) text += fmt::format("<{0}>{1}</{0}>", tag, cell);
  return text + "</tr>\n";
}

std::string number(double value, int digits, bool known) {
  return known ? fmt::format("{:.{}f}", value, digits) : "&ndash;";
}

std::string text(const std::optional<Interval>& interval) {
  if (!interval) return "&ndash;";
  return fmt::format("{:.2f} <small>({:.2f} to {:.2f})</small>", interval->value, interval->low, interval->high);
}

std::string title_of_mode(const std::string& mode) { return mode == "paper" ? "paper's mode" : "articam"; }

}  // namespace

std::string_view pulled_unit(const RunRecord& run) {
  return run.pulled_joint >= 0 && run.joint_is_length[static_cast<std::size_t>(run.pulled_joint)] ? "mm" : "mrad";
}

std::string error_table(const RunRecord& run, const Metrics& metrics) {
  const bool rival = !run.rival_mode.empty(), svd = metrics.svd_position_rms_mm > 0;
  const auto three = [&](std::string_view what, double own, double other, double baseline, int digits) {
    return row(what, {number(own, digits, metrics.evaluated > 0), number(other, digits, rival),
                      number(baseline, digits, svd && baseline > 0)});
  };
  std::string rows =
      "<table>\n" +
      row("RMS error", {title_of_mode(run.mode), rival ? title_of_mode(run.rival_mode) : "", "SVD"}, "th");
  for (const JointMetrics& joint : metrics.joints) {
    rows += three(fmt::format("{}, {}", joint.name, joint.is_length ? "mm" : "mrad"), joint.rms, joint.rival_rms,
                  joint.svd_rms, 3);
  }
  rows += three("base position, mm", metrics.position_rms_mm, metrics.rival_position_rms_mm,
                metrics.svd_position_rms_mm, 3);
  rows += three("base orientation, &deg;", metrics.orientation_rms_deg, metrics.rival_orientation_rms_deg,
                metrics.svd_orientation_rms_deg, 4);
  return rows + "</table>\n";
}

std::string tracker_table(const RunRecord& run, const Metrics& metrics) {
  std::string rows = "<table>\n";
  for (const JointMetrics& joint : metrics.joints) {
    const std::string_view unit = joint.is_length ? "mm" : "mrad";
    rows += row(fmt::format("{}: mean error, {}", joint.name, unit), {fmt::format("{:+.4f}", joint.mean)});
    rows += row(fmt::format("{}: largest error, {}", joint.name, unit), {fmt::format("{:.3f}", joint.max)});
    rows += row(fmt::format("{}: errors within 3 sigma", joint.name),
                {fmt::format("{:.1f} %", 100 * joint.within_3_sigma)});
    if (joint.lag_ms) rows += row(fmt::format("{}: lag, ms", joint.name), {text(joint.lag_ms)});
  }
  for (std::size_t i = 0; i < metrics.frames_by_status.size(); ++i) {
    if (metrics.frames_by_status[i] == 0) continue;
    rows += row(fmt::format("frames <i>{}</i>", name(static_cast<tracker::TrackingStatus>(i))),
                {fmt::format("{} of {}", metrics.frames_by_status[i], run.frames.size())});
  }
  rows += row("residual of the features, median, px", {fmt::format("{:.3f}", metrics.median_rms_px)});
  rows += row("rate of convergence, 1/s", {text(metrics.decay_rate_per_s)});
  rows += row(fmt::format("mean NEES ({} where the claims are true)", run.degrees_of_freedom),
              {fmt::format("{:.1f}", metrics.mean_nees)});
  rows += row("image to estimate, ms: median", {fmt::format("{:.3f}", metrics.step_median_ms)});
  rows += row("99 % of frames, longest", {fmt::format("{:.3f}, {:.3f}", metrics.step_p99_ms, metrics.step_max_ms)});
  return rows + "</table>\n";
}

std::string feedback_table(const RunRecord& run, std::span<const FeedbackRun> feedbacks) {
  const std::string unit = fmt::format(", {}", pulled_unit(run));
  const auto line = [&](const std::string& what, const std::function<std::string(const PullMetrics&)>& cell) {
    std::string text = fmt::format("<tr><th scope=\"row\">{}</th>", what);
    for (const FeedbackRun& f : feedbacks) text += "<td>" + (f.samples.empty() ? "&ndash;" : cell(f.metrics)) + "</td>";
    return text + "</tr>\n";
  };
  const auto digits = [](double PullMetrics::*value, int n) {
    return [value, n](const PullMetrics& m) { return fmt::format("{:.{}f}", m.*value, n); };
  };
  std::string table = "<table>\n<tr><th scope=\"row\">by</th>";
  for (const FeedbackRun& f : feedbacks) table += "<th>" + f.feedback + "</th>";
  table += "</tr>\n";
  table +=
      line("steps that settled", [](const PullMetrics& m) { return fmt::format("{} of {}", m.settled, m.commands); });
  table += line("settling time, s", digits(&PullMetrics::settling_s, 2));
  table += line("overshoot" + unit, digits(&PullMetrics::overshoot, 2));
  table += line("off the target at rest: RMS" + unit, digits(&PullMetrics::error_rms, 3));
  table += line("off the target at rest: peak" + unit, digits(&PullMetrics::error_peak, 2));
  table += line("told wrongly: RMS" + unit, digits(&PullMetrics::told_rms, 3));
  table += line("told wrongly: peak" + unit, digits(&PullMetrics::told_peak, 2));
  table += line("jerk of the hand, RMS, m/s&sup3;", digits(&PullMetrics::jerk_rms, 2));
  return table + "</table>\n";
}

}  // namespace articam::sim
