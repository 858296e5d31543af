#pragma once
/// @file  The model compiler on texts instead of files.

#include <optional>
#include <string>
#include <utility>

#include "tools/modelgen/compile_model.hpp"

namespace articam::modelgen::test {

struct Outcome {
  std::optional<CompiledModel> model;
  std::string messages;  ///< one a line
};

inline Outcome compile_text(std::string urdf, std::optional<std::string> markers = {}, ModelOptions options = {}) {
  CompileJob job{{"m.urdf", std::move(urdf)}, {}, "Model", std::move(options)};
  if (markers) job.markers = SourceFile{"m.yaml", *std::move(markers)};
  Diagnostics diagnostics;
  auto model = compile_model(job, diagnostics);
  return {std::move(model), diagnostics.text()};
}

/// Line 1 holds <robot>; the body starts at line 2.
inline std::string robot(const std::string& body) { return "<robot name=\"r\">\n" + body + "\n</robot>\n"; }

inline ModelOptions with_points(std::initializer_list<const char*> points) {
  ModelOptions options;
  for (const char* point : points) options.points.push_back(*parse_point(point));
  return options;
}

}  // namespace articam::modelgen::test
