#include "tools/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace articam::report {
namespace {

View start_view(const modelgen::Table& table) {
  const auto& q0 = table.q0;
  View view;
  view.T_cam_obj = {Quat<double>(q0[3], q0[4], q0[5], q0[6]).normalized(), Vec3(q0[0], q0[1], q0[2])};
  view.joints = Eigen::Map<const VectorX>(q0.data() + 7, static_cast<Eigen::Index>(q0.size()) - 7);
  return view;
}

void count(const modelgen::UrdfModel& model, Report& report) {
  report.num_links = model.num_links;
  report.num_joints = model.num_joints;
  for (const auto& joint : model.joints) {
    const auto named = [&](const modelgen::TableJoint& row) { return row.name == joint.name; };
    const bool in_table = std::any_of(report.table.joints.begin(), report.table.joints.end(), named);
    if (in_table && !joint.narrowed_by.empty()) {
      report.narrowed.push_back(fmt::format("{} moves between {:.6g} and {:.6g}, where {} can follow", joint.name,
                                            joint.lower, joint.upper, joint.narrowed_by));
    }
    if (!joint.moves()) {
      ++report.num_fixed;
    } else if (joint.mimics) {
      ++report.num_mimics;
    } else if (!joint.held && !in_table) {
      ++report.num_left_out;
    }
  }
}

std::vector<Size> sizes(const modelgen::Table& table, const Conditions& conditions) {
  std::vector<Size> all;
  for (const auto& marker : table.markers) {
    if (!is_mark(marker)) continue;
    const double px_m = conditions.camera.fx_px * marker.outer_diameter_m;
    all.push_back({marker.name, px_m / conditions.min_range_m, px_m / conditions.max_range_m, px_m / kMinDiameter_px});
  }
  return all;
}

}  // namespace

Report make_report(const modelgen::CompiledModel& model, const Conditions& conditions, Says says) {
  Report report;
  report.table = model.table;
  report.conditions = conditions;
  count(model.model, report);
  report.sizes = sizes(model.table, conditions);
  if (report.sizes.empty()) return report;  // nothing will be seen
  report.views = sample_views(model.table, conditions);
  std::optional<View> start;
  if (!model.table.q0.empty()) {
    start = start_view(model.table);
    const Information known = information(look(model.table, *start, conditions.camera));
    report.at_start = bound(known, known_beforehand(model.table), conditions.noise_px);
    report.start_singular_px = least_singular_px(known, model.table);
  }
  report.over_views = observe(model.table, report.views, start ? &*start : nullptr, conditions, says);
  report.symmetries = find_symmetries(model.table, says);
  report.advice = advise(model.table, report.views, conditions, 3, says);
  return report;
}

}  // namespace articam::report
