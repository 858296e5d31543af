#include "host_sim/report/run_folder.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "host_sim/report/figures.hpp"
#include "host_sim/report/truth_csv.hpp"

namespace articam::sim {

std::string write_report(const std::filesystem::path& folder, const Report& report, const Metrics& metrics,
                         const WriteFile& write) {
  const RunRecord& run = report.run;
  // truth.csv and metrics.json first: they do not need gnuplot.
  if (auto problem = write(folder / "truth.csv", truth_csv(run)); !problem.empty()) return problem;
  if (auto problem = write(folder / "metrics.json", metrics_json(run, metrics)); !problem.empty()) return problem;
  std::error_code ignored;
  std::filesystem::remove(folder / "report.html", ignored);  // an old page must not stand beside new numbers
  Figures figures;
  if (draw_figures(run, report.feedbacks, figures) != Status::ok) {
    return fmt::format(
        "no report.html: the program gnuplot is missing or failed (Debian: apt-get install gnuplot-nox). "
        "The CSV files and metrics.json in {} are complete.",
        folder.string());
  }
  const std::vector<Figure>* const chapters[]{&report.pictures, &figures.paper, &figures.robot, &figures.counts};
  for (const auto* chapter : chapters) {
    for (const Figure& figure : *chapter) {
      if (figure.svg.empty()) continue;
      const std::string problem = write(folder / "figures" / (figure.name + ".svg"), figure.svg);
      if (!problem.empty()) return problem;
    }
  }
  return write(folder / "report.html", report_html(report, metrics, figures));
}

std::string summary(const RunRecord& run, const Metrics& metrics) {
  const auto tracked = metrics.frames_by_status[static_cast<std::size_t>(tracker::TrackingStatus::tracking)];
  std::string text = fmt::format("scenario {}, mode {}, seed {}\n", run.scenario, run.mode, run.seed);
  text += fmt::format("  frames tracked      {} of {}\n", tracked, run.frames.size());
  for (const JointMetrics& joint : metrics.joints) {
    text += fmt::format("  {:<19} RMS {:.3f} {}", joint.name, joint.rms, joint.is_length ? "mm" : "mrad");
    if (const auto& lag = joint.lag_ms) {
      text += fmt::format(", lag {:.2f} ms ({:.2f} to {:.2f})", lag->value, lag->low, lag->high);
    }
    text += '\n';
  }
  text += fmt::format("  base                RMS {:.3f} mm, {:.3f} deg\n", metrics.position_rms_mm,
                      metrics.orientation_rms_deg);
  if (const auto& rate = metrics.decay_rate_per_s) {
    text += fmt::format("  convergence         {:.2f} 1/s ({:.2f} to {:.2f})\n", rate->value, rate->low, rate->high);
  }
  text += fmt::format("  image to estimate   {:.2f} ms (median), {:.2f} ms (99 %)\n", metrics.step_median_ms,
                      metrics.step_p99_ms);
  return text;
}

}  // namespace articam::sim
