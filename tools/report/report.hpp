#pragma once
/// @file  Everything that can be said of a model's marks before they are glued.

#include <optional>
#include <string>
#include <vector>

#include "tools/modelgen/compile_model.hpp"
#include "tools/report/observability.hpp"
#include "tools/report/placement.hpp"
#include "tools/report/symmetry.hpp"

namespace articam::report {

/// How large a mark appears, face to face, at the ends of the range.
struct Size {
  std::string marker;
  double nearest_px{}, farthest_px{};
  double max_range_m{};  ///< where it is kMinDiameter_px across
};

struct Report {
  modelgen::Table table;
  std::size_t num_links{}, num_joints{};                  ///< as the file has them
  std::size_t num_mimics{}, num_fixed{}, num_left_out{};  ///< of the joints, planar and floating ones in their parts
  std::vector<std::string> narrowed;                      ///< joints with limits of joints that mimic them
  Conditions conditions;
  std::vector<View> views;
  Observability over_views;
  std::optional<Bound> at_start;  ///< at q0, where the markers file gives one
  double start_singular_px{};     ///< least singular value there
  std::vector<Symmetry> symmetries;
  std::vector<Size> sizes;
  std::vector<Advice> advice;
};

Report make_report(const modelgen::CompiledModel& model, const Conditions& conditions, Says says = silent);

std::string to_text(const Report& report);
std::string to_json(const Report& report);

}  // namespace articam::report
