#include "tools/modelgen/read_yaml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tools/modelgen/parse_number.hpp"

namespace articam::modelgen {

std::optional<YAML::Node> read_yaml(const SourceFile& source, Diagnostics& diagnostics) {
  if (source.bytes.size() > kMaxYamlBytes) {
    diagnostics.error(source.path, 0, "document", "is larger than 64 KiB; 256 markers take half of that");
    return std::nullopt;
  }
  try {
    YAML::Node document = YAML::Load(source.bytes);
    if (document.IsMap()) return document;
    diagnostics.error(source.path, 1, "document", "is not a mapping of keys to values");
  } catch (const YAML::Exception& exception) {
    diagnostics.error(source.path, exception.mark.line + 1, "document", "not well-formed YAML: " + exception.msg);
  }
  return std::nullopt;
}

YamlMap::YamlMap(const SourceFile& source, YAML::Node node, std::string title, Diagnostics& diagnostics)
    : source_{source}, node_{std::move(node)}, title_{std::move(title)}, diagnostics_{diagnostics} {
  if (!is_map()) diagnostics_.error(source_.path, line(), title_, "is not a mapping of keys to values");
}

std::optional<std::string> YamlMap::text(const char* key) {
  if (!is_map()) return std::nullopt;
  const YAML::Node value = get(key);
  if (value.IsDefined() && value.IsScalar() && !value.Scalar().empty()) return value.Scalar();
  error(line_of_key(key), key, value.IsDefined() ? "is not a plain value" : "is missing");
  return std::nullopt;
}

std::optional<double> YamlMap::number(const char* key) {
  const auto word = text(key);
  if (!word) return std::nullopt;
  const auto value = parse_number(*word);
  if (!value) error(line_of_key(key), key, fmt::format("'{}' is not a finite number", *word));
  return value;
}

std::optional<std::vector<double>> YamlMap::numbers(const char* key, std::size_t length) {
  if (!is_map()) return std::nullopt;
  const YAML::Node list = get(key);
  if (!list.IsDefined() || !list.IsSequence()) {
    error(line_of_key(key), key, list.IsDefined() ? "is not a list of numbers" : "is missing");
    return std::nullopt;
  }
  if (length != 0 && list.size() != length) {
    error(line_of(list), key, fmt::format("has {} numbers instead of {}", list.size(), length));
    return std::nullopt;
  }
  std::vector<double> values;
  for (const auto& item : list) {
    const auto value = item.IsScalar() ? parse_number(item.Scalar()) : std::nullopt;
    if (!value) {
      error(line_of(item), key, fmt::format("'{}' is not a finite number", item.IsScalar() ? item.Scalar() : "..."));
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

void YamlMap::check_keys(std::initializer_list<std::string_view> known, UnknownKeys unknown) {
  if (!is_map()) return;
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "...";
    const int line = line_of(entry.first);
    if (!seen.insert(key).second) error(line, key.c_str(), "is given twice; keep one");
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    if (unknown == UnknownKeys::tolerate) {
      diagnostics_.warning(source_.path, line, element(key), "unknown key, ignored");
    } else {
      error(line, key.c_str(), fmt::format("unknown key; known are {}", fmt::join(known, ", ")));
    }
  }
}

void YamlMap::error(int line, const char* key, std::string reason) {
  diagnostics_.error(source_.path, line, element(key), std::move(reason));
}

std::string YamlMap::element(std::string_view key) const {
  return title_.empty() ? std::string(key) : fmt::format("{} {}", title_, key);
}

}  // namespace articam::modelgen
