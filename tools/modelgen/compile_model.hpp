#pragma once
/// @file  Sources in, header out: the whole model compiler as one call.

#include <optional>
#include <string>

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/model_options.hpp"
#include "tools/modelgen/read_urdf.hpp"
#include "tools/modelgen/reduce.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {

struct CompileJob {
  SourceFile urdf;
  std::optional<SourceFile> markers;
  std::string type_name;  ///< CamelCase; the struct in articam::models
  ModelOptions options;
};

struct CompiledModel {
  UrdfModel model;  ///< checked; planar and floating joints are elementary ones, mimics resolved
  Table table;
  std::string header;
};

/// Nothing when the diagnostics hold an error.
std::optional<CompiledModel> compile_model(const CompileJob& job, Diagnostics& diagnostics);

}  // namespace articam::modelgen
