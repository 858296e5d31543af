#include "host_sim/report/paper_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "host_sim/report/metrics.hpp"
#include "host_sim/report/voices.hpp"

namespace articam::sim {
namespace {

using Voice = RunTable::Voice;

constexpr double kStart_s = 3;  ///< shown on a scale of its own: then the paper's mode has come
constexpr int kPanel_px = 135, kGap_px = 14, kTime_px = 56;
constexpr double kLeft = 0.155, kRight = 0.97;

/// One diagram of a stack.
struct Panel {
  enum class Shows { values, errors, band };
  Shows shows{};
  int value{};  ///< of the configuration, see RunTable
  std::string label;
  bool is_commanded{false};
};

std::string error_of(const RunTable& table, Voice voice, int value) {
  return fmt::format("(${}-${})", table.column(voice, value), table.column(Voice::truth, value));
}

/// Truth, all who estimate it, and the command, as in the paper a black dash-dotted line.
std::string values(const RunRecord& run, const RunTable& table, const Panel& panel) {
  std::string curves = fmt::format("plot $run using 1:{} {}", table.column(Voice::truth, panel.value), truth().style);
  for (const Speaker& speaker : estimators(run)) {
    curves += fmt::format(", $run using 1:{} {}", table.column(speaker.voice, panel.value), speaker.style);
  }
  if (panel.is_commanded) curves += fmt::format(", $run using 1:{} with steps {}", +RunTable::kWanted, kCommand);
  return curves;
}

std::string errors(const RunRecord& run, const RunTable& table, const Panel& panel) {
  std::string curves = "plot 0 with lines linecolor rgb '#bdbdbd'";
  for (const Speaker& speaker : estimators(run)) {
    curves += fmt::format(", $run using 1:{} {}", error_of(table, speaker.voice, panel.value), speaker.style);
  }
  return curves;
}

std::string band(const RunRecord& run, const RunTable& table, const Panel& panel) {
  const int std = table.column(Voice::std, panel.value);
  return fmt::format("plot $run using 1:(-3*${0}):(3*${0}) with filledcurves {1}, $run using 1:{2} {3}", std, kBand,
                     error_of(table, Voice::estimate, panel.value), estimate(run).style);
}

std::string curves(const RunRecord& run, const RunTable& table, const Panel& panel) {
  if (panel.shows == Panel::Shows::values) return values(run, table, panel);
  return panel.shows == Panel::Shows::errors ? errors(run, table, panel) : band(run, table, panel);
}

std::vector<KeyEntry> key_of(const RunRecord& run, const std::vector<Panel>& panels) {
  if (panels.front().shows == Panel::Shows::band) {
    return {{"3 sigma", fmt::format("with lines {}", kBandLine)},
            {"error of " + estimate(run).title, estimate(run).style}};
  }
  std::vector<Speaker> speakers = estimators(run);
  speakers.insert(speakers.begin(), truth());
  std::vector<KeyEntry> key = sim::key_of(speakers);
  if (panels.front().is_commanded) key.push_back({"command", fmt::format("with lines {}", kCommand)});
  return key;
}

/// The value below which a share of the numbers lies; 0 of none.
double share_below(double share, std::vector<double> numbers) {
  std::erase_if(numbers, [](double x) { return !std::isfinite(x); });
  if (numbers.empty()) return 0;
  const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(numbers.size() - 1));
  std::nth_element(numbers.begin(), place, numbers.end());
  return *place;
}

/// What a panel shows in [from_s, to_s), so that few wild points do not flatten the rest.
Range range_of(const RunRecord& run, const RunTable& table, const Panel& panel, double from_s, double to_s) {
  constexpr double kWild = 0.002;
  if (panel.shows == Panel::Shows::values) {
    std::vector<int> columns{table.column(Voice::truth, panel.value)};
    for (const Speaker& speaker : estimators(run)) columns.push_back(table.column(speaker.voice, panel.value));
    if (panel.is_commanded) columns.push_back(RunTable::kWanted);
    return table.range(columns, from_s, to_s, from_s > 0 ? kWild : 0);
  }
  const bool alone = panel.shows == Panel::Shows::band;
  std::vector<double> sizes, claims;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    if (table.at(row, RunTable::kTime) < std::min(kEvaluatedFrom_s, 0.5 * to_s)) continue;
    claims.push_back(3 * table.at(row, table.column(Voice::std, panel.value)));
    for (const Speaker& speaker : estimators(run)) {
      if (alone && speaker.voice != Voice::estimate) continue;
      sizes.push_back(std::abs(table.at(row, table.column(speaker.voice, panel.value)) -
                               table.at(row, table.column(Voice::truth, panel.value))));
    }
  }
  // Of the claims the usual ones: while nothing is seen they grow beyond all errors.
  const double size =
      std::max({1.15 * share_below(1 - kWild, sizes), alone ? 1.25 * share_below(0.5, claims) : 0, 1e-4});
  return {-size, size};
}

std::string axes(const Range& time, const Range& shown) {
  return fmt::format("set xrange [{}:{}]\nset yrange [{:.6g}:{:.6g}]\n", time.low, time.high, shown.low, shown.high) +
         tics("y", shown, 5);
}

/// One above the other, the last with the axis of time. Values without a command have their start apart.
Plan stacked(const RunRecord& run, const RunTable& table, std::string name, std::string caption,
             const std::vector<Panel>& panels) {
  const int num = static_cast<int>(panels.size());
  const int height_px = kKey_px + num * kPanel_px + (num - 1) * kGap_px + kTime_px;
  const double end_s = std::max(table.end_s(), 0.1);
  std::string body = "set multiplot\n" + key_strip(key_of(run, panels), height_px) + "set format x ''\n";
  for (int i = 0; i < num; ++i) {
    const Panel& panel = panels[static_cast<std::size_t>(i)];
    const double top = 1 - (kKey_px + i * (kPanel_px + kGap_px)) / static_cast<double>(height_px);
    const double bottom = top - kPanel_px / static_cast<double>(height_px);
    if (i + 1 == num) body += "set format x '%g'\nset xlabel 'time [s]' offset 0,0.4\n";
    const auto plot = [&](double left, double right, const Range& time) {
      body += place(left, right, bottom, top) + axes(time, range_of(run, table, panel, time.low, time.high)) +
              curves(run, table, panel) + "\n";
    };
    const bool split = panel.shows == Panel::Shows::values && !panel.is_commanded && end_s > 2 * kStart_s;
    body += upright(panel.label, 0.5 * (top + bottom)) + (split ? "set xtics 1\n" : "set xtics autofreq\n");
    plot(kLeft, split ? 0.35 : kRight, {0, split ? kStart_s : end_s});
    if (split) {
      body += "unset label 99\nset xtics autofreq\n";
      plot(0.46, kRight, {kStart_s, end_s});
    }
  }
  return {std::move(name), std::move(caption), height_px, {}, body + "unset multiplot\n"};
}

Plan error_norm(const RunRecord& run, const RunTable& table) {
  const Range shown = table.range({RunTable::kErrorNorm, RunTable::kRivalErrorNorm}, 0, 1e9, 0);
  constexpr int kHeight_px = 290;
  std::vector<Speaker> speakers = estimators(run);
  std::erase_if(speakers, [](const Speaker& speaker) { return speaker.voice == Voice::svd; });
  std::string norms;
  for (const Speaker& speaker : speakers) {
    const int column = speaker.voice == Voice::rival ? RunTable::kRivalErrorNorm : RunTable::kErrorNorm;
    norms += fmt::format("{}$run using 1:{} {}", norms.empty() ? "plot " : ", ", column, speaker.style);
  }
  const std::string body =
      "set multiplot\n" + key_strip(sim::key_of(speakers), kHeight_px) +
      fmt::format("set logscale y\nset format y '10^{{%T}}'\nset yrange [1e-5:{}]\nset xrange [0:{}]\n",
                  std::max(1.0, shown.high), std::max(table.end_s(), 0.1)) +
      upright("||e||", 0.55) + "set xlabel 'time [s]' offset 0,0.4\n" + place(kLeft, kRight, 0.2, 0.89) + norms +
      "\nunset multiplot\n";
  return {"figure_3_error_norm",
          "<b>Figure 3.</b> Norm of the error e&nbsp;=&nbsp;s&nbsp;&minus;&nbsp;s* before each frame's first step, "
          "metric image plane. The "
          "paper's mode takes one step a frame: it decays exponentially, stays low while nothing moves, and rises with "
          "every motion that it lags behind. The default's is what one frame brings that was not predicted.",
          kHeight_px, table.data_block(), body};
}

std::string joint_caption(const RunRecord& run, std::size_t joint, int number) {
  const std::string what = fmt::format("<b>Figure {}.</b> Joint <i>{}</i>", number, run.joint_names[joint]);
  const std::string errors =
      " Below, what is wrong with each; at the bottom the default's error alone, with three standard deviations as it "
      "claims them itself.";
  if (static_cast<int>(joint) == run.pulled_joint) {
    return what + ", which the robot moves, and the command (black, dash-dotted)." + errors;
  }
  return what +
         (run.scenario == "paper" && number == 7 ? ", the distance of two markers, a virtual joint: constant, and "
                                                   "to be found. Its first seconds are on a scale of their own."
                                                 : ".") +
         errors;
}

}  // namespace

std::vector<Plan> paper_figures(const RunRecord& run, const RunTable& table) {
  using enum Panel::Shows;
  const std::vector<Panel> position{{values, 0, "x [mm]"}, {values, 1, "y [mm]"}, {values, 2, "z [mm]"}};
  const std::vector<Panel> angles{{values, 3, "roll [deg]"}, {values, 4, "pitch [deg]"}, {values, 5, "yaw [deg]"}};
  const auto banded = [](std::vector<Panel> panels) {
    for (Panel& panel : panels) panel.shows = band;
    return panels;
  };
  std::vector<Plan> plans{
      error_norm(run, table),
      stacked(run, table, "figure_4_position",
              "<b>Figure 4.</b> Position of the object in the camera's frame: x, y and z. Left the first seconds, in "
              "which a bad start is "
              "made good; right the rest, enlarged.",
              position),
      stacked(run, table, "figure_4_errors", "Its error, and three standard deviations as the estimate claims them.",
              banded(position)),
      stacked(run, table, "figure_5_orientation",
              "<b>Figure 5.</b> Orientation of the object in the camera's frame: roll, pitch and yaw, shown likewise.",
              angles),
      stacked(run, table, "figure_5_errors", "The error of that orientation, likewise.", banded(angles))};
  for (std::size_t j = 0; j < run.joint_names.size(); ++j) {
    const int number = 6 + static_cast<int>(j), value = RunTable::kFirstJoint + static_cast<int>(j);
    const std::string unit{joint_unit(run, j)};
    plans.push_back(stacked(run, table, fmt::format("figure_{}_{}", number, run.joint_names[j]),
                            joint_caption(run, j, number),
                            {{values, value, "joint [" + unit + "]", static_cast<int>(j) == run.pulled_joint},
                             {errors, value, "errors [" + unit + "]"},
                             {band, value, "error [" + unit + "]"}}));
  }
  return plans;
}

}  // namespace articam::sim
