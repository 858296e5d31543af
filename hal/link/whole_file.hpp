#pragma once
/// @file  A file that is there whole or not at all.

#include <string>
#include <string_view>

#include "core/status.hpp"

namespace articam::hal {

/// Writes a new file beside the target, `<path>.part` with a number, and renames it on close(). Whatever fails, and
/// where it is destroyed before close(), it removes what it wrote; only a crash leaves that file behind.
class WholeFile {
 public:
  WholeFile() noexcept = default;
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile();

  /// Refuses a target that exists and is not a regular file: renaming would replace the device or the symbolic link
  /// itself, and fail on a folder only after all the work.
  /// Errors of all three  io_error; problem() is then a sentence with path and cause.
  Status open(const std::string& path) noexcept;
  Status write(std::string_view text) noexcept;
  Status close() noexcept;

  const std::string& problem() const noexcept { return problem_; }

 private:
  Status fail(std::string_view what, int error) noexcept;
  void abandon() noexcept;

  int descriptor_{-1};
  std::string path_, part_, problem_;
};

}  // namespace articam::hal
