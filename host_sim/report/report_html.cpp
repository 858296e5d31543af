#include "host_sim/report/report_html.hpp"

#include <fmt/format.h>

#include <string_view>

#include "host_sim/report/report_tables.hpp"

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
       max-width: 42rem; margin: 0 auto; padding: 1rem; overflow-wrap: break-word; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: .5rem 0; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 .5rem; border-top: 1px solid #ddd; padding-top: 1rem; }
p { margin: .5rem 0; }
table { border-collapse: collapse; width: 100%; margin: 1rem 0; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .25rem 0 .25rem .5rem; border-bottom: 1px solid #ddd; vertical-align: top; }
td { white-space: nowrap; }
th { font-weight: 600; }
th[scope=row] { text-align: left; padding-left: 0; font-weight: normal; }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure svg { width: 100%; height: auto; display: block; }
figure svg.photo { max-height: 90vh; }
figcaption, .small { font-size: .875rem; color: #555; margin-top: .25rem; }
.key { display: inline-block; width: 1.5em; height: .3em; margin: 0 .3em .2em .6em; vertical-align: middle; }
@media (max-width: 30rem) { body { padding: .75rem; } table { font-size: .85rem; } }
@media print {
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  h2 { break-after: avoid; } table { break-inside: avoid; } figure { margin: .5rem 0; }
  figure svg { width: 11cm; margin: 0 auto; }
}
</style>
</head>
<body>
)";

/// A file's SVG as a part of the page: without the XML header, and the names that HTML knows by itself.
std::string inlined(const std::string& svg) {
  const std::size_t start = svg.find("<svg");
  if (start == std::string::npos) return {};
  std::string text = svg.substr(start);
  for (const std::string_view known :
       {" xmlns=\"http://www.w3.org/2000/svg\"", " xmlns:xlink=\"http://www.w3.org/1999/xlink\""}) {
    if (const std::size_t at = text.find(known); at != std::string::npos) text.erase(at, known.size());
  }
  return text;
}

std::string chapter(std::string_view title, const std::string& words, std::span<const Figure> figures) {
  std::string text = fmt::format("<h2>{}</h2>\n{}", title, words);
  for (const Figure& figure : figures) {
    if (figure.svg.empty()) continue;
    text += fmt::format("<figure id=\"{}\">\n{}<figcaption>{}</figcaption>\n</figure>\n", figure.name,
                        inlined(figure.svg), figure.caption);
  }
  return text;
}

std::string in_short(const RunRecord& run, const Metrics& metrics) {
  const int tracked = metrics.frames_by_status[static_cast<std::size_t>(tracker::TrackingStatus::tracking)];
  std::string text = fmt::format("<p>The object was tracked in {} of {} frames. ", tracked, run.frames.size());
  if (run.pulled_joint >= 0 && metrics.evaluated > 0) {
    const JointMetrics& joint = metrics.joints[static_cast<std::size_t>(run.pulled_joint)];
    const std::string_view unit = joint.is_length ? "mm" : "mrad";
    text += fmt::format(
        "The joint that the robot moves, <i>{}</i>, was known to {:.3f}&nbsp;{} (RMS; never worse than "
        "{:.2f}&nbsp;{}). ",
        joint.name, joint.rms, unit, joint.max, unit);
    if (joint.rival_rms > 0) {
      text += fmt::format("{} would have been wrong by {:.3f}&nbsp;{} on the same marks",
                          run.rival_mode == "paper" ? "The paper's mode" : "The default", joint.rival_rms, unit);
      text += joint.svd_rms > 0 ? fmt::format(", the SVD baseline by {:.3f}&nbsp;{}.", joint.svd_rms, unit) : ".";
    }
  }
  return text + "</p>\n";
}

std::string introduction(const RunRecord& run) {
  std::string summary = run.summary;
  if (!summary.empty() && summary[0] >= 'a' && summary[0] <= 'z')
    summary[0] = static_cast<char>(summary[0] - 'a' + 'A');
  return fmt::format(
      "<h1>Scenario {}, mode {}</h1>\n<p>{}.</p>\n<p class=\"small\">{} frames, seed {}, {}. Everything is "
      "simulated but the tracker and its loop, which are the board's; so the truth is known.</p>\n",
      run.scenario, run.mode, summary, run.frames.size(), run.seed,
      run.rendered ? fmt::format("noise {:g} grey levels, blur {:g} px", run.noise_grey, run.blur_px)
                   : std::string{"without images: marks with a detector's noise"});
}

std::string key_of_pictures(const RunRecord& run) {
  const auto line = [](std::string_view colour, std::string_view what) {
    return fmt::format("<span class=\"key\" style=\"background:{}\"></span>{}", colour, what);
  };
  std::string text = "<p>" + line("#ffd400", "measured edges") + line("#0050b0", "predicted from the estimate");
  if (!run.rival_mode.empty()) {
    text += line("#00a878", run.rival_mode == "paper" ? "from that of the paper's mode" : "from the default's");
  }
  return text + "</p>\n" +
         (run.rendered
              ? ""
              : "<p class=\"small\">The tracker was given marks; these images are rendered for the eye.</p>\n");
}

std::string words_on_the_robot(const Report& report) {
  std::string text = "<p>The controller goes by what it is told of the joint. ";
  text +=
      report.feedbacks.size() > 1
          ? "The same commands were carried out once by each of these; <i>truth</i> is the best that any could "
            "do.</p>\n"
          : "<code>--compare</code> holds the default, the paper's mode, the SVD baseline and the truth against each "
            "other.</p>\n";
  return text + feedback_table(report.run, report.feedbacks) +
         fmt::format(
             "<p class=\"small\">Settled: near its target for good. At rest: from {:g} s after a command on. Told "
             "wrongly: what the controller believed, less what was so, at every control period.</p>\n",
             kAtRest_s);
}

}  // namespace

std::string report_html(const Report& report, const Metrics& metrics, const Figures& figures) {
  const RunRecord& run = report.run;
  std::string page{kHead};
  page += introduction(run) + in_short(run, metrics) + error_table(run, metrics);
  page += fmt::format(
      "<p class=\"small\">Over the {} frames with an estimate after the first {:g} s. The paper's mode takes one step "
      "a "
      "frame; both modes were given the same marks. The SVD baseline is the paper's equation (7) on the markers' 3-D "
      "positions, each from its own image.</p>\n",
      metrics.evaluated, kEvaluatedFrom_s);
  page += chapter("What the camera saw", key_of_pictures(run), report.pictures);
  page += chapter("The paper's figures", "", figures.paper);
  if (!report.feedbacks.empty())
    page += chapter("What the robot made of it", words_on_the_robot(report), figures.robot);
  page += chapter("How often, how sure, how fast", "", figures.counts);
  page += chapter("More numbers", tracker_table(run, metrics), {});
  page +=
      "<p class=\"small\">Of articam's mode named above. Lag and rate of convergence: least-squares slopes with their "
      "95 % "
      "interval, robust to correlated errors (Newey and West). NEES: squared error by the claimed covariance.</p>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace articam::sim
