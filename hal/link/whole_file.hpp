#pragma once
/// @file  A file that is there whole or not at all.

#include <string>
#include <string_view>

#include "core/status.hpp"

namespace articam::hal {

/// Writes `<path>.part`, and renames it on close(). Destroyed before that, it removes what it wrote.
class WholeFile {
 public:
  WholeFile() noexcept = default;
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile();

  /// Errors of all three  io_error; problem() is then a sentence with path and cause.
  Status open(const std::string& path) noexcept;
  Status write(std::string_view text) noexcept;
  Status close() noexcept;

  const std::string& problem() const noexcept { return problem_; }

 private:
  Status fail(std::string_view what) noexcept;

  int descriptor_{-1};
  std::string path_, part_, problem_;
};

}  // namespace articam::hal
