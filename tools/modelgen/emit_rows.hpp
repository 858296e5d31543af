#pragma once
/// @file  Columns of a table -> aligned rows of C++ braces below a comment that names the columns.

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace articam::modelgen {

using Texts = std::vector<std::string>;

struct Column {
  std::string title;
  Texts cells;
};

/// {a, b, c}
std::string list(const Texts& items);

/// A C++ string literal. Octal escapes have a fixed length, so that no following digit joins them.
std::string literal(const std::string& text);

/// kUnlimited is spelt as the constant.
Column numbers(std::string title, const std::vector<double>& values);

/// One {x, y, z} a row, each component under its like.
template <std::size_t N>
Column vectors(std::string title, const std::vector<std::array<double, N>>& values);

/// `  static constexpr std::array<model::ROW_TYPE, n> NAME{{ rows }};`
std::string emit_rows(const char* row_type, const char* name, const std::vector<Column>& columns);

}  // namespace articam::modelgen
