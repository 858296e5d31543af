#pragma once
/// @file  The table of a static model as the model compiler has it before it writes the header.

#include <fstream>
#include <iterator>
#include <string>

#include "tools/modelgen/compile_model.hpp"

namespace articam::report::test {

inline modelgen::Table static_table(const std::string& name) {
  modelgen::Diagnostics diagnostics;
  const std::string stem = ARTICAM_SOURCE_DIR "/static_models/" + name + "/" + name;
  const auto urdf = modelgen::read_source(stem + ".urdf", diagnostics);
  const auto markers = modelgen::read_source(stem + ".markers.yaml", diagnostics);
  return modelgen::compile_model({*urdf, markers, "Model", {}}, diagnostics)->table;
}

}  // namespace articam::report::test
