#pragma once
/// @file  A picture of the report.

#include <string>

namespace articam::sim {

struct Figure {
  std::string name;     ///< of its file, without .svg
  std::string caption;  ///< HTML: what a person sees in it
  std::string svg;      ///< a whole file; scales with its width
};

}  // namespace articam::sim
