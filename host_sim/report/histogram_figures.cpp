#include "host_sim/report/histogram_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/math/so3.hpp"
#include "host_sim/report/metrics.hpp"
#include "host_sim/report/voices.hpp"

namespace articam::sim {
namespace {

using Voice = RunTable::Voice;

/// Shares of numbers, in percent, in bins of one width.
struct Histogram {
  double low{}, width{};
  std::vector<double> share;

  Histogram(double from, double to, double bin, const std::vector<double>& numbers)
      : low{from}, width{bin}, share(static_cast<std::size_t>((to - from) / bin + 0.5)) {
    for (const double x : numbers) {
      const double place = (x - low) / width;
      const double last = static_cast<double>(share.size() - 1);
      if (!std::isnan(place)) share[static_cast<std::size_t>(std::clamp(place, 0.0, last))] += 1;
    }
    for (double& s : share) s *= 100 / std::max<double>(1, static_cast<double>(numbers.size()));
  }

  /// A data block of centres and shares; `place` makes a gnuplot number of a centre.
  std::string block(const std::string& name, const std::function<double(double)>& place) const {
    std::string data = "$" + name + " << END\n";
    for (std::size_t i = 0; i < share.size(); ++i) {
      data += fmt::format("{:.6g} {:.6g}\n", place(low + (static_cast<double>(i) + 0.5) * width), share[i]);
    }
    return data + "END\n";
  }
};

double power_of_ten(double x) { return std::pow(10, x); }

constexpr double kFrom = -4, kTo = 2.5, kBin = 0.125;  ///< decades of mm and degrees

/// Of one number of the configuration; of three together (position, orientation) their length.
std::vector<double> sizes(const RunTable& table, Voice voice, int first, int count) {
  std::vector<double> all;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    if (table.at(row, RunTable::kTime) < kEvaluatedFrom_s) continue;
    double square = 0;
    for (int i = first; i < first + count; ++i) {
      square += std::pow(table.at(row, table.column(voice, i)) - table.at(row, table.column(Voice::truth, i)), 2);
    }
    if (std::isfinite(square)) all.push_back(std::log10(std::max(std::sqrt(square), 1e-12)));
  }
  return all;
}

/// A style without its `with`.
std::string line_of(const Speaker& speaker) { return speaker.style.substr(speaker.style.find("linewidth")); }

Plan error_sizes(const RunRecord& run, const RunTable& table) {
  struct Row {
    std::string label;
    int first, count;
  };
  std::vector<Row> rows{{"base, position [mm]", 0, 3}, {"base, roll, pitch, yaw [deg]", RunTable::kRoll, 3}};
  for (std::size_t j = 0; j < run.joint_names.size(); ++j) {
    rows.push_back({fmt::format("{} [{}]", run.joint_names[j], joint_unit(run, j)),
                    RunTable::kFirstJoint + static_cast<int>(j), 1});
  }
  constexpr int kRow_px = 105, kGap_px = 32, kFoot_px = 56;
  const int num = static_cast<int>(rows.size()), height_px = kKey_px + num * (kRow_px + kGap_px) + kFoot_px;
  std::vector<KeyEntry> key;
  for (const Speaker& speaker : estimators(run)) key.push_back({speaker.title, "with lines " + line_of(speaker)});
  std::string data;
  std::string body = "set multiplot\n" + key_strip(key, height_px) +
                     fmt::format(
                         "set logscale x\nset xrange [1e-4:{:.4g}]\nset format x ''\nset yrange [0:*]\n"
                         "set ytics 20\nset style fill transparent solid 0.25\n",
                         power_of_ten(kTo));
  for (int i = 0; i < num; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    const double top = 1 - (kKey_px + kGap_px - 8.0 + i * (kRow_px + kGap_px)) / height_px;
    const double bottom = top - 1.0 * kRow_px / height_px;
    if (i + 1 == num) body += "set format x '10^{%T}'\nset xlabel 'size of the error, mm or deg' offset 0,0.4\n";
    body += place(0.1, 0.97, bottom, top) + upright("%", 0.5 * (top + bottom)) +
            fmt::format("set label 1 '{}' at graph 0,1.1 left noenhanced\n", row.label);
    std::string curves;
    for (const Speaker& speaker : estimators(run)) {
      const std::string block = fmt::format("sizes_{}_{}", i, static_cast<int>(speaker.voice));
      data += Histogram{kFrom, kTo, kBin, sizes(table, speaker.voice, row.first, row.count)}.block(block, power_of_ten);
      const std::string colour = speaker.style.substr(speaker.style.find("linecolor"), 23);
      curves += fmt::format("{}${} with fillsteps {}, ${} with steps {}", curves.empty() ? "plot " : ", ", block,
                            colour, block, line_of(speaker));
    }
    body += curves + "\n";
  }
  return {"error_sizes",
          "How often errors of each size occur, by a scale on which every factor of ten is as wide. Farther left is "
          "better.",
          height_px, data, body + "unset multiplot\n"};
}

Plan claims(const RunRecord& run, const RunTable& table) {
  constexpr double kFarthest = 5, kWidth = 0.25;
  std::vector<double> scores;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    if (table.at(row, RunTable::kTime) < kEvaluatedFrom_s) continue;
    for (int i = 0; i < table.num_values(); ++i) {
      const double error =
          table.at(row, table.column(Voice::estimate, i)) - table.at(row, table.column(Voice::truth, i));
      const double score = error / table.at(row, table.column(Voice::std, i));
      if (std::isfinite(score)) scores.push_back(score);
    }
  }
  const std::string data = Histogram{-kFarthest, kFarthest, kWidth, scores}.block("scores", [](double x) { return x; });
  constexpr int kHeight_px = 270;
  const KeyEntry key[]{{estimate(run).title, fmt::format("with lines {}", kBandLine)},
                       {"true claims", fmt::format("with lines {}", kCommand)}};
  const std::string body =
      "set multiplot\n" + key_strip(key, kHeight_px) +
      fmt::format(
          "set xrange [-{0}:{0}]\nset yrange [0:*]\nset style fill transparent solid 0.25\nset samples 200\n"
          "set xlabel 'error by its claimed standard deviation' offset 0,0.4\n",
          kFarthest) +
      upright("%", 0.55) + place(0.1, 0.97, 0.22, 0.88) +
      fmt::format(
          "plot $scores with boxes linecolor rgb '#0072b2', {}*exp(-x**2/2)/sqrt(2*pi) with lines {}\n"
          "unset multiplot\n",
          100 * kWidth, kCommand);
  return {
      "claims",
      "Is the estimate as good as it says? Every error, of the base and of the joints, by the standard deviation "
      "that the estimate claimed for it. Narrower than the curve: better than claimed; wider: worse. Columns at the "
      "edges hold all beyond.",
      kHeight_px, data, body};
}

Plan step_times(const RunRecord& run) {
  std::vector<double> logs;
  for (const FrameRecord& frame : run.frames) {
    if (frame.step_s > 0) logs.push_back(std::log10(1000 * frame.step_s));
  }
  constexpr double kLow = -3, kHigh = 2;
  const std::string data = Histogram{kLow, kHigh, 0.1, logs}.block("times", power_of_ten);
  const std::string body =
      "set logscale x\nset xrange [1e-3:100]\nset yrange [0:*]\nset style fill transparent solid 0.25\n"
      "unset key\nset xlabel 'image to estimate [ms]' offset 0,0.4\nset format x '%g'\n"
      "set arrow 1 from 33.3, graph 0 to 33.3, graph 1 nohead linecolor rgb '#202020' dashtype 2\n"
      "set label 1 'next frame' at 30, graph 0.92 right\n" +
      upright("%", 0.6) + place(0.1, 0.97, 0.24, 0.95) +
      "plot $times with fillsteps linecolor rgb '#0072b2', $times with steps linecolor rgb '#0072b2'\n";
  return {
      "step_times",
      "How long the tracker took from an image to its estimate, on the machine that ran the simulation, whatever else "
      "ran there. At 30 Hz the next frame comes after 33 ms.",
      230, data, body};
}

}  // namespace

std::vector<Plan> histogram_figures(const RunRecord& run, const RunTable& table) {
  return {error_sizes(run, table), claims(run, table), step_times(run)};
}

}  // namespace articam::sim
