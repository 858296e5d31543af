#pragma once
/// @file  A run as gnuplot's columns.

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/report/gnuplot.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// A row a frame. Lengths in mm, angles in degrees, those of the base within half a turn of the truth; NaN where there
/// is none. Columns count from 1, as gnuplot's.
class RunTable {
 public:
  enum Column : int { kTime = 1, kErrorNorm, kRivalErrorNorm, kWanted, kStatus, kFixedColumns = kStatus };
  /// Who says it.
  enum class Voice { truth, estimate, svd, rival, std };
  /// Of a configuration: x y z, roll pitch yaw, then the joints.
  static constexpr int kRoll = 3, kFirstJoint = 6;

  explicit RunTable(const RunRecord& run);

  int column(Voice voice, int i) const { return kFixedColumns + 1 + static_cast<int>(voice) * width_ + i; }
  int num_values() const { return width_; }  ///< of a configuration
  double at(std::size_t row, int column) const { return rows_[row][static_cast<std::size_t>(column - 1)]; }
  std::size_t num_rows() const { return rows_.size(); }
  double end_s() const { return rows_.empty() ? 0 : rows_.back().front(); }

  /// What these columns hold in [from_s, to_s), but for their `share` smallest and largest, and a tenth of it around.
  Range range(const std::vector<int>& columns, double from_s, double to_s, double share) const;

  /// $run, for gnuplot.
  std::string data_block() const;

 private:
  void append(const PlainConfiguration* q, const PlainConfiguration& truth, const RunRecord& run,
              std::vector<double>& row) const;

  int width_;
  std::vector<std::vector<double>> rows_;
};

/// mm or degrees.
double joint_scale(const RunRecord& run, std::size_t joint);
std::string_view joint_unit(const RunRecord& run, std::size_t joint);

}  // namespace articam::sim
