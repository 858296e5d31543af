#include "host_sim/report/run_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/report/roll_pitch_yaw.hpp"

namespace articam::sim {
namespace {

constexpr double kMmPerM = 1000, kDegPerRad = 180 / 3.14159265358979323846;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class T>
const T* pointer(const std::optional<T>& value) {
  return value ? &*value : nullptr;
}

}  // namespace

double joint_scale(const RunRecord& run, std::size_t joint) {
  return run.joint_is_length[joint] ? kMmPerM : kDegPerRad;
}
std::string_view joint_unit(const RunRecord& run, std::size_t joint) {
  return run.joint_is_length[joint] ? "mm" : "deg";
}

RunTable::RunTable(const RunRecord& run) : width_{kFirstJoint + static_cast<int>(run.joint_names.size())} {
  const double wanted_scale = run.pulled_joint < 0 ? 1 : joint_scale(run, static_cast<std::size_t>(run.pulled_joint));
  for (const FrameRecord& frame : run.frames) {
    std::vector<double> row{frame.t_s, frame.estimate ? frame.error_norm : kNone,
                            frame.rival ? frame.rival_error_norm : kNone,
                            frame.wanted ? *frame.wanted * wanted_scale : kNone, static_cast<double>(frame.status)};
    for (const PlainConfiguration* q :
         {&frame.truth, pointer(frame.estimate), pointer(frame.svd), pointer(frame.rival)}) {
      append(q, frame.truth, run, row);
    }
    row.resize(static_cast<std::size_t>(column(Voice::std, width_) - 1), kNone);
    if (const auto& claimed = frame.claimed) {
      const auto out = row.begin() + column(Voice::std, 0) - 1;
      for (int i = 0; i < 3; ++i) {
        out[i] = kMmPerM * claimed->position[i];
        out[kRoll + i] = kDegPerRad * claimed->roll_pitch_yaw[i];
      }
      for (std::size_t j = 0; j < claimed->joints.size(); ++j) {
        out[kFirstJoint + static_cast<int>(j)] = joint_scale(run, j) * claimed->joints[j];
      }
    }
    rows_.push_back(std::move(row));
  }
}

void RunTable::append(const PlainConfiguration* q, const PlainConfiguration& truth, const RunRecord& run,
                      std::vector<double>& row) const {
  if (q == nullptr) return row.resize(row.size() + static_cast<std::size_t>(width_), kNone);
  for (int i = 0; i < 3; ++i) row.push_back(kMmPerM * q->T_cam_obj.t[i]);
  const Vec<double, 3> angles = kDegPerRad * roll_pitch_yaw(q->T_cam_obj.R);
  const Vec<double, 3> true_angles = kDegPerRad * roll_pitch_yaw(truth.T_cam_obj.R);
  for (int i = 0; i < 3; ++i) row.push_back(true_angles[i] + std::remainder(angles[i] - true_angles[i], 360));
  for (std::size_t j = 0; j < q->joints.size(); ++j) row.push_back(joint_scale(run, j) * q->joints[j]);
}

Range RunTable::range(const std::vector<int>& columns, double from_s, double to_s, double share) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const int column : columns) {
    std::vector<double> values;
    for (const auto& row : rows_) {
      const double x = row[static_cast<std::size_t>(column - 1)];
      if (row.front() >= from_s && row.front() < to_s && std::isfinite(x)) values.push_back(x);
    }
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    const auto left_out = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    low = std::min(low, values[left_out]), high = std::max(high, values[values.size() - 1 - left_out]);
  }
  if (!(low <= high)) return {-1, 1};
  const double margin = std::max(0.1 * (high - low), 1e-3);
  return {low - margin, high + margin};
}

std::string RunTable::data_block() const {
  std::string data = "$run << END\n";
  for (const auto& row : rows_) data += fmt::format("{:.8g}\n", fmt::join(row, " "));
  return data + "END\n";
}

}  // namespace articam::sim
