#pragma once
/// @file  The link to a file: estimates.csv.

#include <string>

#include "core/status.hpp"
#include "hal/link/csv_row.hpp"
#include "hal/link/whole_file.hpp"

namespace articam::hal {

/// Writes one row an estimate. The file appears under its name only by close(): until then, and after a crash, there is
/// `<path>.part`. After open() nothing allocates.
template <class Estimate>
class FileLink;

template <class Model, class S>
class FileLink<tracker::Estimate<Model, S>> {
 public:
  /// Errors  io_error when the file cannot be created; whole_file().problem() says why.
  Status open(const std::string& path) noexcept {
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
  const WholeFile& whole_file() const noexcept { return file_; }

 private:
  Status write_line() noexcept {
    line_.put("\n");
    return line_.overflowed() ? Status::io_error : file_.write(line_.text());
  }

  WholeFile file_;
  CsvLine<Model> line_;
};

}  // namespace articam::hal
