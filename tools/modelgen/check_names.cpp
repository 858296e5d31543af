// Names end up as string literals and columns of CSV files.
#include <algorithm>
#include <array>

#include "tools/modelgen/characters.hpp"
#include "tools/modelgen/check_model.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {
namespace {

// clang-format off
constexpr std::array<std::string_view, 97> kKeywords{
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch", "char",
    "char16_t", "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl", "concept", "const",
    "const_cast", "consteval", "constexpr", "constinit", "continue", "decltype", "default", "delete", "do", "double",
    "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "if",
    "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or",
    "or_eq", "private", "protected", "public", "register", "reinterpret_cast", "requires", "return", "short", "signed",
    "sizeof", "static", "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local", "throw",
    "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual", "void", "volatile",
    "wchar_t", "while", "xor", "xor_eq"};
// clang-format on

/// Beyond letters, digits and UTF-8: what real URDF files use in names.
bool fits_a_name(char c) {
  constexpr std::string_view kMarks = " _-.:/[]()+@";
  return is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80 || kMarks.find(c) != kMarks.npos;
}

}  // namespace

std::string_view why_not_a_name(std::string_view text) {
  if (text.size() > 128) return "is longer than 128 bytes; shorten it";
  if (find_non_text(text) != text.npos) return "is not UTF-8, by a character reference; rename it";
  if (!std::all_of(text.begin(), text.end(), fits_a_name)) {
    return "holds a quote or sign that generated code and CSV columns cannot carry; rename it";
  }
  if (std::find(kKeywords.begin(), kKeywords.end(), text) != kKeywords.end()) return "is a C++ keyword; rename it";
  return "";
}

bool is_type_name(std::string_view text) {
  const auto fits = [](char c) { return is_letter(c) || is_digit(c); };
  return !text.empty() && text[0] >= 'A' && text[0] <= 'Z' && text.size() <= 128 &&
         std::all_of(text.begin(), text.end(), fits);
}

}  // namespace articam::modelgen
