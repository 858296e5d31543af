#include "tools/modelgen/compile_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "tools/modelgen/check_model.hpp"
#include "tools/modelgen/emit_header.hpp"
#include "tools/modelgen/expand_joints.hpp"
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

}  // namespace

std::optional<CompiledModel> compile_model(const CompileJob& job, Diagnostics& diagnostics) {
  MarkersFile markers;
  if (job.markers) {
    if (auto parsed = read_markers(*job.markers, diagnostics)) markers = std::move(*parsed);
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
  std::vector<Origin> origins{origin("shape", job.urdf)};
  if (job.markers) origins.push_back(origin("markers", *job.markers));
  result.header = emit_header(result.table, job.type_name, origins, spell(job.options));
  result.model = *std::move(model);
  return result;
}

}  // namespace articam::modelgen
