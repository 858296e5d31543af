#include "host_sim/report/report_html.hpp"

#include <fmt/format.h>

#include <string_view>

namespace articam::sim {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>articam: simulated run</title>
<style>
body { font: 16px/1.5 system-ui, sans-serif; color: #222; background: #fff;
       max-width: 46rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: .5rem 0; }
h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; }
p { margin: .5rem 0; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .3rem .5rem; border-bottom: 1px solid #ddd; vertical-align: top; }
td + td, th + th { text-align: right; }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure svg { width: 100%; height: auto; display: block; }
figcaption, .small { font-size: .875rem; color: #555; }
@media print { body { max-width: none; font-size: 11pt; } h2 { break-after: avoid; } }
</style>
</head>
<body>
)";

std::string row(std::string_view what, std::string_view articam, std::string_view svd = "") {
  return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", what, articam, svd);
}

std::string text(const std::optional<Interval>& interval, std::string_view unit) {
  if (!interval) return "&ndash;";
  return fmt::format("{:.2f} {} ({:.2f} to {:.2f})", interval->value, unit, interval->low, interval->high);
}

std::string joint_rows(const JointMetrics& joint) {
  const std::string_view unit = joint.is_length ? "mm" : "mrad";
  const std::string svd = joint.is_length ? fmt::format("{:.3f} mm", joint.svd_rms) : "";
  return row(joint.name + ", RMS error", fmt::format("{:.3f} {}", joint.rms, unit), svd) +
         row(joint.name + ", mean error", fmt::format("{:.3f} {}", joint.mean, unit)) +
         row(joint.name + ", largest error", fmt::format("{:.3f} {}", joint.max, unit)) +
         (joint.lag_ms ? row(joint.name + ", lag", text(joint.lag_ms, "ms")) : "");
}

std::string statuses(const Metrics& metrics) {
  std::string list;
  for (std::size_t i = 0; i < metrics.frames_by_status.size(); ++i) {
    if (metrics.frames_by_status[i] == 0) continue;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", metrics.frames_by_status[i],
                        name(static_cast<tracker::TrackingStatus>(i)));
  }
  return list;
}

std::string table(const RunRecord& run, const Metrics& metrics) {
  std::string rows = "<table>\n<tr><th></th><th>articam</th><th>SVD baseline</th></tr>\n";
  rows += row("frames", statuses(metrics));
  for (const JointMetrics& joint : metrics.joints) rows += joint_rows(joint);
  rows += row("base position, RMS error", fmt::format("{:.3f} mm", metrics.position_rms_mm),
              fmt::format("{:.3f} mm", metrics.svd_position_rms_mm));
  rows += row("base orientation, RMS error", fmt::format("{:.3f}&deg;", metrics.orientation_rms_deg),
              fmt::format("{:.3f}&deg;", metrics.svd_orientation_rms_deg));
  rows += row("residual of the features, median", fmt::format("{:.3f} px", metrics.median_rms_px));
  rows += row("rate of convergence", text(metrics.decay_rate_per_s, "1/s"));
  rows += row(fmt::format("mean NEES ({} where the covariance is true)", run.degrees_of_freedom),
              fmt::format("{:.1f}", metrics.mean_nees));
  rows +=
      row("image to estimate, median / 99 % / longest",
          fmt::format("{:.3f} / {:.3f} / {:.3f} ms", metrics.step_median_ms, metrics.step_p99_ms, metrics.step_max_ms));
  return rows + "</table>\n";
}

std::string figure(const std::string& svg, const std::string& caption) {
  return fmt::format("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", svg, caption);
}

}  // namespace

std::string report_html(const RunRecord& run, const Metrics& metrics, const std::string& picture_svg,
                        double picture_t_s, std::span<const Figure> figures) {
  std::string page{kHead};
  page += fmt::format("<h1>Scenario {}, mode {}</h1>\n", run.scenario, run.mode);
  page += fmt::format(
      "<p>{} frames, seed {}, noise {:g} grey levels, blur {:g} px. The images are synthetic, "
      "so the truth is known.</p>\n",
      run.frames.size(), run.seed, run.noise_grey, run.blur_px);
  page +=
      figure(picture_svg, fmt::format("The camera's frame at {:.1f} s. Orange: the markers' outlines at the estimated "
                                      "configuration.",
                                      picture_t_s));
  page += "<h2>In numbers</h2>\n" + table(run, metrics);
  page += fmt::format(
      "<p class=\"small\">Errors are over the {} frames with an estimate after the first {:g} s. Lag and rate of "
      "convergence: least-squares slopes with their 95 % interval, robust to correlated errors (Newey and West). The "
      "SVD "
      "baseline is the paper's equation (7) on the markers' 3-D positions, each from its own image.</p>\n",
      metrics.evaluated, kEvaluatedFrom_s);
  page += "<h2>Over time</h2>\n";
  for (const Figure& drawn : figures) page += figure(drawn.svg, drawn.caption);
  return page + "</body>\n</html>\n";
}

}  // namespace articam::sim
