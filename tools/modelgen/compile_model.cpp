#include "tools/modelgen/compile_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "tools/modelgen/check_model.hpp"
#include "tools/modelgen/check_start.hpp"
#include "tools/modelgen/emit_header.hpp"
#include "tools/modelgen/expand_joints.hpp"
#include "tools/modelgen/identifiers.hpp"
#include "tools/modelgen/read_markers.hpp"
#include "tools/modelgen/resolve_mimics.hpp"

namespace articam::modelgen {
namespace {

/// The options in one spelling, so that equal requests give equal headers.
std::string spell(const ModelOptions& options) {
  std::vector<std::string> words;
  if (!options.root.empty()) words.push_back("--root " + options.root);
  for (const auto& [joint, value] : options.freeze) words.push_back(fmt::format("--freeze {}={}", joint, value));
  for (const Marker& point : options.points) {
    words.push_back(fmt::format("--poi {}={}:{}", point.name, point.frame, fmt::join(point.offset_m, ",")));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

Origin origin(const char* role, const SourceFile& source) { return {role, source.file_name(), sha256(source.bytes)}; }

/// Names whose identifier is not theirs alone.
void warn_of_alike(const std::vector<std::string>& names, const char* kind, const std::string& file,
                   Diagnostics& diagnostics) {
  const std::vector<std::string> identifiers = to_identifiers(names, kind);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (identifiers[i] == to_identifiers({names[i]}, kind)[0]) continue;
    diagnostics.warning(file, 0, title(kind, names[i]),
                        fmt::format("is {} in code: without the number it would be another's name", identifiers[i]));
  }
}

void warn_of_alike(const Table& table, const std::string& file, Diagnostics& diagnostics) {
  std::vector<std::string> joints, markers;
  for (const TableJoint* joint : table.values()) joints.push_back(joint->name);
  for (const TableMarker& marker : table.markers) markers.push_back(marker.name);
  warn_of_alike(joints, "Joint", file, diagnostics);
  warn_of_alike(markers, "Marker", file, diagnostics);
}

}  // namespace

std::optional<CompiledModel> compile_model(const CompileJob& job, Diagnostics& diagnostics) {
  MarkersFile markers;
  if (job.markers) {
    if (auto parsed = read_markers(*job.markers, diagnostics)) markers = std::move(*parsed);
    check_start(markers, diagnostics);
  }
  auto model = read_urdf(job.urdf, diagnostics);
  if (!model) return std::nullopt;
  expand_joints(*model, diagnostics);
  check_model(*model, markers, job.options, diagnostics);
  resolve_mimics(*model, job.options, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;

  CompiledModel result;
  result.table = reduce(*model, markers, job.options, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  warn_of_alike(result.table, job.urdf.path, diagnostics);
  std::vector<Origin> origins{origin("shape", job.urdf)};
  if (job.markers) origins.push_back(origin("markers", *job.markers));
  result.header = emit_header(result.table, job.type_name, origins, spell(job.options));
  result.model = *std::move(model);
  return result;
}

}  // namespace articam::modelgen
