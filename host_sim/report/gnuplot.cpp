#include "host_sim/report/gnuplot.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace articam::sim {
namespace {

namespace fs = std::filesystem;

const std::string kFrame =
    "set grid linecolor rgb '#e4e4e4'\nset border 31 linecolor rgb '#707070'\nset tics scale 0.5\n"
    "set xtics\nset ytics\n";

double tic_step(double spread, int most) {
  if (!(spread > 0)) return 1;
  double step = 1;
  while (step > spread / 50) step /= 10;
  while (step < spread / 50) step *= 10;  // now spread / step is 5 to 50
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (spread / (step * factor) <= most) return step * factor;
  }
  return (spread / (10 * step) <= most ? 10 : 20) * step;
}

std::string script_of(std::span<const Plan> plans, const fs::path& folder) {
  std::string script;
  for (const Plan& plan : plans) {
    script += plan.data + "reset\n" +
              fmt::format("set terminal svg size {},{} dynamic name '{}' font 'sans-serif,14' background rgb 'white'\n",
                          kWidth_px, plan.height_px, plan.name) +
              fmt::format("set output '{}'\n", (folder / (plan.name + ".svg")).string()) + kFrame + plan.body +
              "unset output\n";
  }
  return script;
}

}  // namespace

std::string tics(std::string_view axis, const Range& range, int most) {
  return fmt::format("set {}tics {}\n", axis, tic_step(range.high - range.low, most));
}

std::string key_strip(std::span<const KeyEntry> entries, int height_px) {
  // By hand: gnuplot's own makes every column as wide as the widest, which five do not allow.
  constexpr double kSample_px = 26, kLetter_px = 7.6, kApart_px = 18;
  double width_px = -kApart_px;
  for (const KeyEntry& entry : entries) {
    width_px += kSample_px + kLetter_px * (static_cast<double>(entry.title.size()) + 0.5) + kApart_px;
  }
  double x_px = 0.5 * (kWidth_px - width_px);
  std::string labels, curves, data;
  for (const KeyEntry& entry : entries) {
    curves += fmt::format("{}'-' {}", curves.empty() ? "plot " : ", ", entry.style);
    data += fmt::format("{} 0.5\n{} 0.5\ne\n", x_px, x_px + kSample_px);
    x_px += kSample_px + 0.5 * kLetter_px;
    labels += fmt::format("set label '{}' at {},0.5 left noenhanced\n", entry.title, x_px);
    x_px += kLetter_px * static_cast<double>(entry.title.size()) + kApart_px;
  }
  return "unset key\nunset border\nunset tics\n" + place(0, 1, 1 - 1.0 * kKey_px / height_px, 1) +
         fmt::format("set xrange [0:{}]\nset yrange [0:1]\n", kWidth_px) + labels + curves + '\n' + data + kFrame +
         "unset label\nset xrange [*:*]\nset yrange [*:*]\n";
}

std::string upright(const std::string& label, double centre) {
  return fmt::format("set label 99 '{}' at screen 0.03,{} center rotate by 90 noenhanced\n", label, centre);
}

std::string place(double left, double right, double bottom, double top) {
  return fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n", left,
      right, bottom, top);
}

Status draw(std::span<const Plan> plans, std::vector<Figure>& figures) {
  figures.clear();
  std::error_code error;
  // A folder of its own, so that no name needs quoting.
  std::string folder = (fs::temp_directory_path(error) / "articam-figures-XXXXXX").string();
  if (error || mkdtemp(folder.data()) == nullptr) return Status::io_error;
  const fs::path script = fs::path{folder} / "figures.gp";
  std::ofstream{script} << script_of(plans, folder);
  bool drawn = std::system(("gnuplot '" + script.string() + "' 2>/dev/null").c_str()) == 0;
  for (const Plan& plan : plans) {
    std::ostringstream content;
    content << std::ifstream{fs::path{folder} / (plan.name + ".svg")}.rdbuf();
    drawn = drawn && content.str().find("</svg>") != std::string::npos;
    figures.push_back({plan.name, plan.caption, content.str()});
  }
  fs::remove_all(folder, error);
  return drawn ? Status::ok : Status::io_error;
}

}  // namespace articam::sim
