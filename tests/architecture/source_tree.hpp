#pragma once
/// @file  The text of the repository, for the tests that read it.

#include <string>
#include <string_view>
#include <vector>

namespace articam::architecture {

struct SourceFile {
  std::string path;  ///< from the root of the repository, with forward slashes
  std::string text;
};

/// What a rule found: printed as `path:line: reason`, which editors can follow.
struct Violation {
  std::string path;
  int line{};
  std::string reason;
};
using Violations = std::vector<Violation>;

/// Every file that people wrote: code, build files, scripts and words. Build and output folders, hidden
/// folders but .ci, and data are left out. Sorted by path.
std::vector<SourceFile> read_source_tree();

/// The lines of a text, without their ends.
std::vector<std::string_view> lines_of(std::string_view text);

/// One line for each violation; empty when there is none.
std::string to_string(const Violations& violations);

}  // namespace articam::architecture
