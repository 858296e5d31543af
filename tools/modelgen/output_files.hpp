#pragma once
/// @file  What a program writes: whole files, and all of them or none.

#include <string>
#include <vector>

namespace articam::modelgen {

struct OutputFile {
  std::string path;
  std::string bytes;
};

/// Writes every file beside its target; when all are there they take their places, by renaming. So a target is the old
/// file or the new one, never half of one, and all stay old if one cannot be written.
/// A target that exists and is not a regular file (a folder, a symbolic link, a device) is refused.
/// Returns an empty text, or `PATH: output: REASON`.
std::string write_files(const std::vector<OutputFile>& files);

}  // namespace articam::modelgen
