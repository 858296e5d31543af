#include "tests/architecture/hygiene.hpp"

#include <algorithm>
#include <array>

namespace articam::architecture {
namespace {

// In two halves, so that this file passes its own rule.
// clang-format off
constexpr std::array<std::string_view, 3> kUndone{"TO" "DO", "FIX" "ME", "HA" "CK"};
// clang-format on
constexpr std::array<std::string_view, 5> kEmptyNames{"util", "helper", "manager", "common", "misc"};

bool is_code(std::string_view path) {
  return path.ends_with(".hpp") || path.ends_with(".cpp") || path.ends_with(".sh") || path.ends_with(".cmake") ||
         path.ends_with("CMakeLists.txt");
}

/// Tables are as long and as wide as the object they describe.
bool is_generated(const SourceFile& file) { return file.text.starts_with("// GENERATED"); }

/// Characters, not bytes: UTF-8 continuation bytes do not count.
auto width(std::string_view line) {
  return std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

void check_line(const SourceFile& file, std::string_view line, int number, Violations& out) {
  if (line.find('\t') != std::string_view::npos) out.push_back({file.path, number, "a tab"});
  if (line.ends_with(' ') || line.ends_with('\r')) out.push_back({file.path, number, "blanks at the end of the line"});
  if (is_code(file.path) && !is_generated(file) && width(line) > kMaxColumns) {
    out.push_back({file.path, number, std::to_string(width(line)) + " columns"});
  }
  for (const std::string_view word : kUndone) {
    if (line.find(word) != std::string_view::npos)
      out.push_back({file.path, number, "work left undone: " + std::string{word}});
  }
}

}  // namespace

Violations check_hygiene(const SourceFile& file) {
  Violations violations;
  if (file.path == "LICENSE") return violations;  // the words of its authors
  const auto lines = lines_of(file.text);
  int number = 0;
  for (const std::string_view line : lines) check_line(file, line, ++number, violations);
  if (is_code(file.path) && !is_generated(file) && number > kMaxLines) {
    violations.push_back({file.path, number, "more than " + std::to_string(kMaxLines) + " lines: two ideas?"});
  }
  if (!file.text.ends_with('\n')) violations.push_back({file.path, number, "no newline at the end"});
  if (file.path.ends_with(".hpp") && !std::ranges::count(lines, "#pragma once")) {
    violations.push_back({file.path, 1, "no #pragma once"});
  }
  const std::string_view name = std::string_view{file.path}.substr(file.path.rfind('/') + 1);
  for (const std::string_view word : kEmptyNames) {
    if (name.find(word) != std::string_view::npos)
      violations.push_back({file.path, 1, "a file name that says nothing"});
  }
  return violations;
}

}  // namespace articam::architecture
