#pragma once
/// @file  The pieces of text that generated headers are made of.

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

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

}  // namespace articam::modelgen
