#include "tools/modelgen/emit_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "tools/modelgen/emit_rows.hpp"
#include "tools/modelgen/emit_sketch.hpp"
#include "tools/modelgen/emit_text.hpp"
#include "tools/modelgen/identifiers.hpp"

namespace articam::modelgen {
namespace {

std::string emit_origins(const std::vector<Origin>& origins, const std::string& options) {
  std::size_t width = 0;
  for (const Origin& origin : origins) width = std::max(width, origin.file_name.size());
  std::string text;
  for (const Origin& origin : origins) {
    const std::string name = fmt::format("{:<{}}", origin.file_name, width);
    text += fmt::format("//   {:<7}  {}  sha256 {}\n", origin.role, comment(name), origin.sha256);
  }
  if (!options.empty()) text += "//   options  " + comment(options) + '\n';
  return text;
}

std::array<double, 3> plain(const Vec<double, 3>& v) { return {v.x(), v.y(), v.z()}; }
std::array<double, 4> plain(const Quat<double>& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// One value of every row.
template <class Rows, class Get>
auto each(const Rows& rows, Get get) {
  std::vector<decltype(get(rows.front()))> values;
  for (const auto& row : rows) values.push_back(get(row));
  return values;
}

std::string emit_joints(const std::vector<TableJoint>& joints) {
  using J = TableJoint;
  std::vector<Column> columns{
      {"name", each(joints, [](const J& j) { return literal(j.name); })},
      {"kind", each(joints, [](const J& j) { return std::string(word(j.kind)); })},
      {"parent", each(joints, [](const J& j) { return fmt::format("{:2}", j.parent); })},
      vectors("axis", each(joints, [](const J& j) { return plain(j.axis); })),
      vectors("t_parent_joint_m", each(joints, [](const J& j) { return plain(j.T_parent_joint.t); })),
      vectors("r_wxyz", each(joints, [](const J& j) { return plain(j.T_parent_joint.R); })),
      numbers("q_min", each(joints, [](const J& j) { return j.q_min; })),
      numbers("q_max", each(joints, [](const J& j) { return j.q_max; }))};
  if (std::any_of(joints.begin(), joints.end(), [](const J& j) { return j.leader >= 0; })) {
    columns.push_back({"leader", each(joints, [](const J& j) { return fmt::format("{:2}", j.leader); })});
    columns.push_back(numbers("ratio", each(joints, [](const J& j) { return j.ratio; })));
    columns.push_back(numbers("offset", each(joints, [](const J& j) { return j.offset; })));
  }
  return emit_rows("JointRow", "kJoints", columns);
}

std::string emit_markers(const std::vector<TableMarker>& markers) {
  using M = TableMarker;
  return emit_rows("MarkerRow", "kMarkers",
                   {{"name", each(markers, [](const M& m) { return literal(m.name); })},
                    {"kind", each(markers, [](const M& m) { return std::string(word(m.kind)); })},
                    {"body", each(markers, [](const M& m) { return fmt::format("{:2}", m.body); })},
                    vectors("t_body_m", each(markers, [](const M& m) { return plain(m.t_body_m); })),
                    vectors("normal", each(markers, [](const M& m) { return plain(m.normal); })),
                    numbers("outer_diameter_m", each(markers, [](const M& m) { return m.outer_diameter_m; })),
                    numbers("inner_diameter_m", each(markers, [](const M& m) { return m.inner_diameter_m; }))});
}

/// Nothing where no joint is held.
std::string emit_frozen(const std::vector<TableFrozen>& frozen) {
  using F = TableFrozen;
  if (frozen.empty()) return "";
  return emit_rows("FrozenRow", "kFrozen",
                   {{"name", each(frozen, [](const F& f) { return literal(f.name); })},
                    numbers("value", each(frozen, [](const F& f) { return f.value; }))});
}

/// `struct KIND { enum : int { kFirst, kSecond }; };`, or nothing where there is nothing to name.
std::string emit_indices(const char* kind, const Texts& originals) {
  if (originals.empty()) return "";
  std::string text, line = "    enum : int {";
  for (const std::string& identifier : to_identifiers(originals, kind)) {
    if (line.size() + identifier.size() > 100) {
      text += line + '\n';
      line = "     ";
    }
    line += ' ' + identifier + ',';
  }
  line.back() = ' ';
  return fmt::format("  struct {} {{\n{}{}}};\n  }};\n", kind, text, line);
}

std::string emit_names(const Table& table) {
  const std::string joints = emit_indices("Joint", each(table.values(), [](const TableJoint* j) { return j->name; }));
  const std::string markers = emit_indices("Marker", each(table.markers, [](const TableMarker& m) { return m.name; }));
  return "  // Indices by name: of the joint values in q, and of the rows of kMarkers.\n" + joints + markers;
}

std::string emit_start(const Table& table) {
  std::vector<double> q0 = table.q0;
  if (q0.empty()) {
    q0.assign(7 + table.values().size(), 0);
    q0[3] = 1;
  }
  const char* const meaning = table.q0.empty() ? "No start is given: kQ0 means nothing." : "Start of the tracker:";
  return fmt::format("  // {} t_m and r_wxyz of {{obj}} in {{cam}}, then the joints.\n", meaning) +
         fmt::format("  static constexpr bool kHasQ0 = {};\n", !table.q0.empty()) +
         fmt::format("  static constexpr std::array<double, {}> kQ0{};\n", q0.size(), list(each(q0, number)));
}

}  // namespace

std::string emit_header(const Table& table, const std::string& type_name, const std::vector<Origin>& origins,
                        const std::string& options) {
  return "// GENERATED by articam-modelgen. Do not edit: change the source and build again.\n" +
         emit_origins(origins, options) + "//\n" + sketch(table) +
         "//\n"
         "// Units m, rad. T_parent_joint maps points of {joint} into {parent}; quaternions w x y z.\n"
         "// Rows are ordered so that a parent comes before its children; -1 is the root, {obj}.\n"
         "// Composed numbers are rounded to 15 decimals.\n"
         "#pragma once\n"
         "#include <array>\n"
         "#include <string_view>\n"
         "\n"
         "#include \"core/model/model_table.hpp\"\n"
         "\n"
         "namespace articam::models {\n"
         "struct " +
         type_name +
         " {\n"
         "  using enum model::JointKind;\n"
         "  using enum model::MarkerKind;\n"
         "  static constexpr std::string_view kName = " +
         literal(table.robot) +
         ";\n"
         "  // clang-format off\n" +
         emit_joints(table.joints) + emit_markers(table.markers) + emit_frozen(table.frozen) + emit_start(table) +
         emit_names(table) +
         "  // clang-format on\n"
         "};\n"
         "static_assert(model::kTableSchema == " +
         std::to_string(model::kTableSchema) +
         ", \"table layout changed: regenerate\");\n"
         "static_assert(model::is_well_formed<" +
         type_name +
         ">());  // parents first, unit axes, ordered limits\n"
         "}  // namespace articam::models\n";
}

}  // namespace articam::modelgen
