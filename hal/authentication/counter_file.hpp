#pragma once
/// @file  A number that survives a restart and a loss of power.

#include <cstdint>
#include <string>

#include "core/status.hpp"

namespace articam::hal {

/// One line of text, `articam-counter 1 <number of 20 digits> <CRC-32>`. Written to `<path>.part`, synced and renamed,
/// and then the folder is synced: whenever the power goes, the file is the old one or the new one. A `.part` that was
/// left behind is removed by the next, never written to.
class CounterFile {
 public:
  explicit CounterFile(std::string path) : path_{std::move(path)} {}

  /// 0 where there is no file yet.
  /// Errors of all three  io_error: cannot be read or written; bad_argument: it is not a whole counter file, and is
  /// left as it is. problem() is then a sentence.
  Status read(std::uint64_t& number);
  Status write(std::uint64_t number);
  /// Adds to the number on the disk; `before` is what it was. Another program cannot come in between.
  Status add(std::uint64_t amount, std::uint64_t& before);

  const std::string& problem() const noexcept { return problem_; }

 private:
  Status fail(Status why, const std::string& what);

  std::string path_;
  std::string problem_;
};

}  // namespace articam::hal
