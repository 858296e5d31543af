#pragma once
/// @file  Typed values out of a YAML mapping; whatever is wrong is reported with its line.

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {

inline constexpr std::size_t kMaxYamlBytes = 64 << 10;  ///< yaml-cpp takes some 200 bytes of memory for each

/// The document's outermost mapping, or nothing after having said what is wrong.
std::optional<YAML::Node> read_yaml(const SourceFile& source, Diagnostics& diagnostics);

inline int line_of(const YAML::Node& node) { return node.Mark().line + 1; }

/// One mapping. Every getter reports its own error and then returns nothing.
class YamlMap {
 public:
  /// `title` names the mapping in messages; empty for the outermost one.
  YamlMap(const SourceFile& source, YAML::Node node, std::string title, Diagnostics& diagnostics);

  bool has(const char* key) const { return is_map() && get(key).IsDefined(); }
  bool is_map() const { return node_.IsMap(); }
  int line() const { return line_of(node_); }
  int line_of_key(const char* key) const { return has(key) ? line_of(get(key)) : line(); }
  /// Children that need their own reader.
  YAML::Node get(const char* key) const { return node_[key]; }

  std::optional<std::string> text(const char* key);
  std::optional<double> number(const char* key);
  /// A sequence of numbers, of that length unless it is 0.
  std::optional<std::vector<double>> numbers(const char* key, std::size_t length);

  /// Keys given twice are errors; keys outside the list are errors or, if tolerated, warnings.
  enum class UnknownKeys { refuse, tolerate };
  void check_keys(std::initializer_list<std::string_view> known, UnknownKeys unknown);

  void error(int line, const char* key, std::string reason);

 private:
  std::string element(std::string_view key) const;

  const SourceFile& source_;
  YAML::Node node_;
  std::string title_;
  Diagnostics& diagnostics_;
};

}  // namespace articam::modelgen
