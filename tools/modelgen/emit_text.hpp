#pragma once
/// @file  The pieces of text that generated headers are made of.

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/model/model_table.hpp"

namespace articam::modelgen {

/// Shortest text that reads back as the same number, in every locale.
inline std::string number(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// Text for a // comment, which no character may leave or continue.
inline std::string comment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < 0x20 || c >= 0x7f || c == '\\' || c == '?'; }, '_');
  return text;
}

/// The enumerators, as `using enum` makes them known in a header.
inline std::string_view word(model::JointKind kind) {
  constexpr std::array<std::string_view, 3> kWords{"revolute", "continuous", "prismatic"};
  return kWords[static_cast<std::size_t>(kind)];
}

inline std::string_view word(model::MarkerKind kind) {
  constexpr std::array<std::string_view, 4> kWords{"point", "ring", "dot_light_on_dark", "dot_dark_on_light"};
  return kWords[static_cast<std::size_t>(kind)];
}

}  // namespace articam::modelgen
