#include "host_sim/report/figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include "core/math/trigonometry.hpp"

namespace articam::sim {
namespace {

constexpr double kDegPerRad = 180 / 3.14159265358979323846;

/// Columns of a configuration: x y z (m), roll pitch yaw (deg), joints (m or rad).
constexpr std::size_t kBaseColumns = 6;

/// Euler Z-Y-X, degrees: roll about x, pitch about y, yaw about z.
Vec<double, 3> roll_pitch_yaw_deg(const Quat<double>& q) {
  const double sin_pitch = 2 * (q.w() * q.y() - q.z() * q.x());
  const double cos_pitch2 = 1 - sin_pitch * sin_pitch;
  const double roll = math::atan2(2 * (q.w() * q.x() + q.y() * q.z()), 1 - 2 * (q.x() * q.x() + q.y() * q.y()));
  const double pitch = math::atan2(sin_pitch, std::sqrt(cos_pitch2 > 0 ? cos_pitch2 : 0.0));
  const double yaw = math::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
  return kDegPerRad * Vec<double, 3>{roll, pitch, yaw};
}

/// What gnuplot gets of a frame: time, error norm, then the columns of truth, estimate and SVD baseline; NaN where
/// there is none.
class Table {
 public:
  explicit Table(const RunRecord& run) : width_{kBaseColumns + run.joint_names.size()} {
    for (const FrameRecord& frame : run.frames) {
      std::vector<double> row{frame.t_s, frame.estimate ? frame.error_norm : kNone};
      for (const auto& q : {std::optional{frame.truth}, frame.estimate, frame.svd}) append(q, row);
      row.push_back(frame.wanted.value_or(kNone));
      rows_.push_back(std::move(row));
    }
  }

  std::size_t truth(std::size_t column) const { return 2 + column; }
  std::size_t estimate(std::size_t column) const { return 2 + width_ + column; }
  std::size_t svd(std::size_t column) const { return 2 + 2 * width_ + column; }
  std::size_t wanted() const { return 2 + 3 * width_; }

  std::string data_block() const {
    std::string data = "$run << END\n";
    for (const auto& row : rows_) data += fmt::format("{:.6g}\n", fmt::join(row, " "));
    return data + "END\n";
  }

  /// Largest minus smallest of the numbers that `values` makes of each row.
  template <class Values>
  double spread(const Values& values) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& row : rows_) {
      for (const double x : values(row)) {  // a NaN is neither smaller nor larger
        low = x < low ? x : low, high = x > high ? x : high;
      }
    }
    return high > low ? high - low : 0;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  void append(const std::optional<PlainConfiguration>& q, std::vector<double>& row) const {
    if (!q) return row.resize(row.size() + width_, kNone);
    const Vec<double, 3> t = q->T_cam_obj.t, angles = roll_pitch_yaw_deg(q->T_cam_obj.R);
    row.insert(row.end(), {t.x(), t.y(), t.z(), angles.x(), angles.y(), angles.z()});
    row.insert(row.end(), q->joints.begin(), q->joints.end());
  }

  std::size_t width_;
  std::vector<std::vector<double>> rows_;
};

/// One diagram: a column's three curves, or the estimate's error.
struct Panel {
  std::string label;
  std::size_t column;
  double scale;
  bool is_error = false;
  bool is_commanded = false;  ///< a robot was told where it should be
};

/// A step of 1, 2 or 5 times a power of ten that puts at most six marks on an axis.
double tic_step(double spread) {
  if (!(spread > 0)) return 1;
  double step = 1;
  while (step > spread / 50) step /= 10;
  while (step < spread / 50) step *= 10;  // now spread / step is 5 to 50
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (spread / (step * factor) <= 6) return step * factor;
  }
  return 10 * step;
}

std::string curves(const Table& table, const Panel& panel) {
  const std::size_t truth = table.truth(panel.column), estimate = table.estimate(panel.column);
  const std::size_t svd = table.svd(panel.column);
  if (panel.is_error) {
    const double spread =
        table.spread([&](const auto& row) { return std::array{panel.scale * (row[estimate] - row[truth])}; });
    return fmt::format("set ytics {}\nplot $run using 1:((${} - ${})*{}) with lines linecolor rgb '#00509d' notitle\n",
                       tic_step(spread), estimate + 1, truth + 1, panel.scale);
  }
  const double spread = panel.scale * table.spread([&](const auto& row) {
    return std::array{row[truth], row[estimate], row[svd]};
  });
  // As in the paper: what the robot was told is a black dash-dotted line.
  const std::string command =
      panel.is_commanded
          ? fmt::format("$run using 1:(${}*{}) with steps dashtype 4 linecolor rgb '#202020' title 'command', ",
                        table.wanted() + 1, panel.scale)
          : "";
  // Gnuplot counts columns from 1. The wide line of the truth comes first, so that what agrees with it stays visible.
  return fmt::format(
      "set ytics {4}\nplot {5}$run using 1:(${0}*{3}) with lines linewidth 4 linecolor rgb '#b8b8b8' title 'truth', "
      "$run using 1:(${2}*{3}) with lines dashtype 2 linecolor rgb '#d1495b' title 'SVD', "
      "$run using 1:(${1}*{3}) with lines linewidth 1.2 linecolor rgb '#00509d' title 'articam'\n",
      truth + 1, estimate + 1, svd + 1, panel.scale, tic_step(spread), command);
}

struct Plan {
  std::string caption, body;
  int height_px;
};

/// Panels one above the other; the first has the key, the last the axis of time.
Plan stacked(const Table& table, const std::string& caption, const std::vector<Panel>& panels) {
  constexpr int kPanel_px = 170, kKey_px = 34, kTime_px = 84;
  const int height_px = kPanel_px * static_cast<int>(panels.size()) + kKey_px + kTime_px;
  std::string script = fmt::format("set multiplot layout {},1 margins 0.14,0.98,{},{} spacing 0.05\n", panels.size(),
                                   1.0 * kTime_px / height_px, 1 - 1.0 * kKey_px / height_px);
  script += "set key horizontal outside top right\nset format x ''\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (i + 1 == panels.size()) script += "set format x '%g'\nset xlabel 'time [s]'\n";
    script += fmt::format("set ylabel '{}'\n", panels[i].label) + curves(table, panels[i]) + "unset key\n";
  }
  return {caption, script + "unset multiplot\n", height_px};
}

/// Runs gnuplot on a script, in a folder of its own so that no name needs quoting.
Status run_gnuplot(const std::string& script, std::string& svg) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "articam-figure-XXXXXX").string();
  if (error || mkdtemp(folder.data()) == nullptr) return Status::io_error;
  const fs::path script_path = fs::path{folder} / "figure.gp", svg_path = fs::path{folder} / "figure.svg";
  std::ofstream{script_path} << "set output '" << svg_path.string() << "'\n" << script;
  const bool drawn = std::system(("gnuplot '" + script_path.string() + "' 2>/dev/null").c_str()) == 0;
  if (drawn) {
    std::ostringstream content;
    content << std::ifstream{svg_path}.rdbuf();
    svg = content.str();
  }
  fs::remove_all(folder, error);
  const std::size_t start = svg.find("<svg");
  if (!drawn || start == std::string::npos) return Status::io_error;
  svg.erase(0, start);  // the XML header has no place inside a page
  for (const char* name : {" xmlns=\"http://www.w3.org/2000/svg\"", " xmlns:xlink=\"http://www.w3.org/1999/xlink\""}) {
    if (const std::size_t at = svg.find(name); at != std::string::npos) {
      svg.erase(at, std::char_traits<char>::length(name));
    }
  }
  return Status::ok;
}

Status draw(int number, int height_px, const std::string& data, const std::string& body, Figure& figure) {
  const std::string head = fmt::format(
      "set terminal svg size 720,{} dynamic name 'figure{}' font 'sans-serif,14' background rgb 'white'\n"
      "set grid linecolor rgb '#e4e4e4'\nset datafile missing 'nan'\nset border linecolor rgb '#707070'\n",
      height_px, number);
  return run_gnuplot(head + data + body, figure.svg);
}

}  // namespace

Status draw_figures(const RunRecord& run, std::vector<Figure>& figures) {
  const Table table{run};
  std::vector<Plan> plans{
      {"Norm of the error e = s - s* before each frame's first step, metric image plane (paper, figure 3).",
       "set logscale y\nset format y '10^{%T}'\nset xlabel 'time [s]'\nset ylabel '||e||'\nset lmargin at screen 0.14\n"
       "plot $run using 1:2 with lines linecolor rgb '#00509d' notitle\n",
       300},
      stacked(table, "Position of the base in the camera's frame (paper, figure 4).",
              {{"x [mm]", 0, 1000}, {"y [mm]", 1, 1000}, {"z [mm]", 2, 1000}}),
      stacked(table, "Roll, pitch and yaw of the base in the camera's frame (paper, figure 5).",
              {{"roll [deg]", 3, 1}, {"pitch [deg]", 4, 1}, {"yaw [deg]", 5, 1}})};
  for (std::size_t j = 0; j < run.joint_names.size(); ++j) {
    const std::string unit = run.joint_is_length[j] ? "mm" : "deg";
    const double scale = run.joint_is_length[j] ? 1000 : kDegPerRad;
    const std::string paper = run.scenario == "paper" ? fmt::format(" (paper, figure {})", 6 + j) : "";
    plans.push_back(
        stacked(table, fmt::format("Joint {}{}, and articam's error.", run.joint_names[j], paper),
                {{"joint [" + unit + "]", kBaseColumns + j, scale, false, static_cast<int>(j) == run.pulled_joint},
                 {"error [" + unit + "]", kBaseColumns + j, scale, true}}));
  }
  figures.clear();
  const std::string data = table.data_block();
  for (const Plan& plan : plans) {
    Figure figure{plan.caption, {}};
    const Status drawn = draw(static_cast<int>(figures.size()) + 3, plan.height_px, data, plan.body, figure);
    if (drawn != Status::ok) return drawn;
    figures.push_back(figure);
  }
  return Status::ok;
}

}  // namespace articam::sim
