#pragma once
/// @file  Markers file -> which links carry a mark, its kind and size, and where the tracker may start.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/model/model_table.hpp"
#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {

/// The link's origin, or what `offset_m` says, is the centre of the mark, the link's +z its outward normal.
struct Marker {
  std::string frame;  ///< a link of the URDF
  int line{};
  model::MarkerKind kind{};
  double outer_diameter_m{};         ///< of a dot: its diameter; 0 for a point
  double inner_diameter_m{};         ///< of a ring; 0 otherwise
  std::array<double, 3> offset_m{};  ///< its place in the link's frame
  std::string name;                  ///< of a mark: its frame; of a point: its own
};

struct MarkersFile {
  std::string file;
  std::vector<Marker> markers;            ///< in the order of the file, which is the table's order too
  std::optional<std::vector<double>> q0;  ///< px py pz qw qx qy qz, then the joints of the table
  int q0_line{};
};

/// Errors  not YAML, unknown or missing keys, malformed numbers, sizes that no mark can have, rings that the
///         detector cannot find: an inner diameter outside 0.1875 to 0.75 of the outer one, or several such ratios.
std::optional<MarkersFile> read_markers(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace articam::modelgen
