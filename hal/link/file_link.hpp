#pragma once
/// @file  The link to a file: estimates.csv.

#include <string>

#include "core/status.hpp"
#include "hal/link/csv_row.hpp"
#include "hal/link/whole_file.hpp"

namespace articam::hal {

/// Writes one row an estimate. The file appears under its name only by close() (see WholeFile). After open() nothing
/// allocates, unless it fails.
template <class Estimate>
class FileLink;

template <class Model, class S>
class FileLink<tracker::Estimate<Model, S>> {
 public:
  /// Errors of all three  io_error; problem() says why.
  Status open(const std::string& path) noexcept {
    problem_.clear();
    if (const Status status = file_.open(path); status != Status::ok) return status;
    line_.clear();
    put_csv_header<Model>(line_);
    return write_line();
  }
  Status publish(const tracker::Estimate<Model, S>& estimate) noexcept {
    line_.clear();
    put_csv_row(estimate, line_);
    return write_line();
  }
  Status close() noexcept { return file_.close(); }
  const std::string& problem() const noexcept { return problem_.empty() ? file_.problem() : problem_; }

 private:
  Status write_line() noexcept {
    line_.put("\n");
    if (!line_.overflowed()) return file_.write(line_.text());
    problem_ = "estimates.csv: a line is longer than its buffer: give the joints shorter names";
    return Status::io_error;
  }

  WholeFile file_;
  CsvLine<Model> line_;
  std::string problem_;
};

}  // namespace articam::hal
