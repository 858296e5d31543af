#pragma once
/// @file  The sources of a static model, and what modelgen makes of them.

#include <gtest/gtest.h>

#include <string>

#include "tools/modelgen/compile_model.hpp"

namespace articam::test {

inline std::string static_path(const std::string& model, const std::string& extension) {
  return ARTICAM_STATIC_MODELS "/" + model + "/" + model + extension;
}

inline modelgen::SourceFile static_source(const std::string& model, const std::string& extension) {
  modelgen::Diagnostics diagnostics;
  const auto source = modelgen::read_source(static_path(model, extension), diagnostics);
  EXPECT_TRUE(source) << diagnostics.text();
  return source.value_or(modelgen::SourceFile{});
}

inline modelgen::CompiledModel compile(const modelgen::SourceFile& urdf,
                                       const std::optional<modelgen::SourceFile>& markers,
                                       const modelgen::ModelOptions& options = {}) {
  modelgen::Diagnostics diagnostics;
  const auto compiled = modelgen::compile_model({urdf, markers, "Tested", options}, diagnostics);
  EXPECT_TRUE(compiled) << diagnostics.text();
  return compiled.value_or(modelgen::CompiledModel{});
}

}  // namespace articam::test
