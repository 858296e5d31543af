#include "tools/modelgen/identifiers.hpp"

#include <cstddef>
#include <set>

#include "tools/modelgen/characters.hpp"

namespace articam::modelgen {
namespace {

std::string to_identifier(const std::string& name) {
  std::string identifier = "k";
  bool starts_word = true;
  for (const char c : name) {
    if (!is_letter(c) && !is_digit(c)) {
      starts_word = true;
      continue;
    }
    if (starts_word && is_digit(c) && is_digit(identifier.back())) identifier += '_';
    identifier += starts_word && is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c;
    starts_word = false;
  }
  return identifier;
}

}  // namespace

std::vector<std::string> to_identifiers(const std::vector<std::string>& names, const std::string& kind) {
  std::vector<std::string> identifiers;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string identifier = to_identifier(names[i]);
    if (identifier == "k") identifier += kind + std::to_string(i);
    while (!taken.insert(identifier).second) identifier += '_' + std::to_string(i);
    identifiers.push_back(identifier);
  }
  return identifiers;
}

}  // namespace articam::modelgen
