#include "tools/modelgen/emit_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "tools/modelgen/emit_text.hpp"

namespace articam::modelgen {
namespace {

using Texts = std::vector<std::string>;

struct Column {
  std::string title;
  Texts cells;
};

std::string limit(double x) {
  if (x == model::kUnlimited) return "model::kUnlimited";
  return x == -model::kUnlimited ? "-model::kUnlimited" : number(x);
}

std::string list(const Texts& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "{" : ", ") + item;
  return text + "}";
}

/// A C++ string literal. Octal escapes have a fixed length, so that no following digit joins them.
std::string literal(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c >= 0x20 && c < 0x7f ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return quoted + '"';
}

std::string_view word(model::JointKind kind) {
  constexpr std::array<std::string_view, 3> kWords{"revolute", "continuous", "prismatic"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string_view word(model::MarkerKind kind) {
  constexpr std::array<std::string_view, 4> kWords{"point", "ring", "dot_light_on_dark", "dot_dark_on_light"};
  return kWords[static_cast<std::size_t>(kind)];
}

void align_right(Texts& cells) {
  std::size_t width = 0;
  for (const std::string& cell : cells) width = std::max(width, cell.size());
  for (std::string& cell : cells) cell.insert(0, width - cell.size(), ' ');
}

Column numbers(std::string title, const std::vector<double>& values) {
  Column column{std::move(title), {}};
  for (const double x : values) column.cells.push_back(limit(x));
  align_right(column.cells);
  return column;
}

/// One {x, y, z} a row, each component under its like.
template <std::size_t N>
Column vectors(std::string title, const std::vector<std::array<double, N>>& values) {
  std::vector<Texts> rows(values.size());
  for (std::size_t i = 0; i < N; ++i) {
    Texts component;
    for (const auto& value : values) component.push_back(number(value[i]));
    align_right(component);
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].push_back(component[row]);
  }
  Column column{std::move(title), {}};
  for (const Texts& row : rows) column.cells.push_back(list(row));
  return column;
}

/// Rows `    {a, b},` below a comment that names the columns.
std::string aligned(const std::vector<Column>& columns) {
  const std::size_t num_rows = columns.front().cells.size();
  std::string head = "    // ";
  Texts rows(num_rows, "    {");
  for (const Column& column : columns) {
    const bool last = &column == &columns.back();
    head += column.title;
    std::size_t end = head.size();
    for (std::size_t i = 0; i < num_rows; ++i) {
      rows[i] += column.cells[i] + (last ? "},\n" : ",");
      end = std::max(end, rows[i].size());
    }
    if (last) break;
    head.resize(end + 1, ' ');
    for (std::string& row : rows) row.resize(end + 1, ' ');
  }
  return fmt::format("{}\n{}", head, fmt::join(rows, ""));
}

std::string sketch_markers(const Table& table, int body) {
  std::string names;
  for (const TableMarker& marker : table.markers) {
    if (marker.body == body) names += (names.empty() ? "" : ", ") + marker.name;
  }
  return names.empty() ? "" : "  [" + names + "]";
}

/// The branches below a body, one a line; `stem` is what runs on from the lines above.
std::string sketch(const Table& table, int body, const std::string& stem) {
  std::vector<int> children;
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    if (table.joints[i].parent == body) children.push_back(static_cast<int>(i));
  }
  std::string text;
  for (const int child : children) {
    const TableJoint& joint = table.joints[static_cast<std::size_t>(child)];
    const bool last = child == children.back();
    const std::string branch = fmt::format("{}{} {} ({}) --> {}{}", stem, last ? "`--" : "|--", joint.name,
                                           word(joint.kind), joint.child_link, sketch_markers(table, child));
    text += "//   " + comment(branch) + '\n' + sketch(table, child, stem + (last ? "    " : "|   "));
  }
  return text;
}

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

std::string emit_rows(const char* row_type, const char* name, const std::vector<Column>& columns) {
  const std::size_t size = columns.front().cells.size();
  const std::string declaration = fmt::format("  static constexpr std::array<model::{}, {}> {}", row_type, size, name);
  return size == 0 ? declaration + "{};\n" : declaration + "{{\n" + aligned(columns) + "  }};\n";
}

std::string emit_joints(const std::vector<TableJoint>& joints) {
  using J = TableJoint;
  return emit_rows("JointRow", "kJoints",
                   {{"name", each(joints, [](const J& j) { return literal(j.name); })},
                    {"kind", each(joints, [](const J& j) { return std::string(word(j.kind)); })},
                    {"parent", each(joints, [](const J& j) { return fmt::format("{:2}", j.parent); })},
                    vectors("axis", each(joints, [](const J& j) { return plain(j.axis); })),
                    vectors("t_parent_joint_m", each(joints, [](const J& j) { return plain(j.T_parent_joint.t); })),
                    vectors("r_wxyz", each(joints, [](const J& j) { return plain(j.T_parent_joint.R); })),
                    numbers("q_min", each(joints, [](const J& j) { return j.q_min; })),
                    numbers("q_max", each(joints, [](const J& j) { return j.q_max; }))});
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

std::string emit_start(const Table& table) {
  std::vector<double> q0 = table.q0;
  if (q0.empty()) {
    q0.assign(7 + table.joints.size(), 0);
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
         emit_origins(origins, options) + "//\n//   " + comment(table.root_link + sketch_markers(table, -1)) + '\n' +
         sketch(table, -1, "") +
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
         emit_joints(table.joints) + emit_markers(table.markers) + emit_start(table) +
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
