#include "tools/modelgen/emit_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/model/model_table.hpp"
#include "tools/modelgen/emit_text.hpp"

namespace articam::modelgen {
namespace {

std::string limit(double x) {
  if (x == model::kUnlimited) return "model::kUnlimited";
  return x == -model::kUnlimited ? "-model::kUnlimited" : number(x);
}

void align_right(Texts& cells) {
  std::size_t width = 0;
  for (const std::string& cell : cells) width = std::max(width, cell.size());
  for (std::string& cell : cells) cell.insert(0, width - cell.size(), ' ');
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

}  // namespace

std::string list(const Texts& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "{" : ", ") + item;
  return text + "}";
}

std::string literal(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c >= 0x20 && c < 0x7f ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return quoted + '"';
}

Column numbers(std::string title, const std::vector<double>& values) {
  Column column{std::move(title), {}};
  for (const double x : values) column.cells.push_back(limit(x));
  align_right(column.cells);
  return column;
}

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
template Column vectors(std::string, const std::vector<std::array<double, 3>>&);
template Column vectors(std::string, const std::vector<std::array<double, 4>>&);

std::string emit_rows(const char* row_type, const char* name, const std::vector<Column>& columns) {
  const std::size_t size = columns.front().cells.size();
  const std::string declaration = fmt::format("  static constexpr std::array<model::{}, {}> {}", row_type, size, name);
  return size == 0 ? declaration + "{};\n" : declaration + "{{\n" + aligned(columns) + "  }};\n";
}

}  // namespace articam::modelgen
