#pragma once
/// @file  How often a page says something.

#include <string>

namespace articam::sim::test {

inline std::size_t count(const std::string& page, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = page.find(word); at != std::string::npos; at = page.find(word, at + 1)) ++n;
  return n;
}

}  // namespace articam::sim::test
