#pragma once
/// @file  Estimates -> estimates.csv, row by row.

#include <memory>
#include <string>
#include <utility>

#include "tools/listen/output.hpp"
#include "tools/listen/record_file.hpp"

namespace articam::listen {

/// No line end. `frame,t_s,status,reason,px,...,matched,rms_px`, the columns that articam-replay writes.
std::string csv_header(const wire::ModelMessage& model);

/// The very bytes that articam-replay writes for the same estimate. t_s is counted from `t_zero`.
std::string csv_row(const wire::EstimateMessage& estimate, std::size_t num_joints, Timestamp t_zero = {});

/// Writes rows in the order of receipt. The first estimate gives the joints' names; one of a model with other names
/// is a failure, because its numbers would stand under wrong ones.
class CsvOutput : public Output {
 public:
  /// `relative`: t_s counts from the session's first estimate.
  CsvOutput(std::unique_ptr<RecordFile> file, bool relative) : file_{std::move(file)}, relative_{relative} {}

  std::string take(const Heard& heard) override;
  std::string finish() override { return file_->close(); }

 private:
  std::unique_ptr<RecordFile> file_;
  bool relative_;
  std::string header_;
};

}  // namespace articam::listen
