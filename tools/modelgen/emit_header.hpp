#pragma once
/// @file  A table -> the C++ header that holds it. Same table, same bytes, on every machine.

#include <string>
#include <vector>

#include "tools/modelgen/reduce.hpp"

namespace articam::modelgen {

/// What a header says of its origin: `shape  door.urdf  sha256 ...`.
struct Origin {
  std::string role;       ///< shape, markers
  std::string file_name;  ///< without folders: no path of a machine
  std::string sha256;
};

/// The whole text. `options` repeats what the command line asked beyond the files; may be empty.
std::string emit_header(const Table& table, const std::string& type_name, const std::vector<Origin>& origins,
                        const std::string& options);

}  // namespace articam::modelgen
