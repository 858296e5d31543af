#include "tools/modelgen/read_markers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tools/modelgen/read_yaml.hpp"

namespace articam::modelgen {
namespace {

/// A positive length below 10 m; anything else is a slip of the unit.
double read_diameter(YamlMap& map, const char* key) {
  const auto value = map.number(key);
  if (!value) return 0;
  if (!(*value > 0 && *value < 10)) {
    map.error(map.line_of_key(key), key, fmt::format("{} is not between 0 and 10 m", *value));
  }
  return *value;
}

/// Metres, as a diameter's: beyond 10 it is a slip of the unit.
void read_offset(YamlMap& map, Marker& marker) {
  if (!map.has("offset_m")) return;
  const auto numbers = map.numbers("offset_m", 3);
  if (!numbers) return;
  for (std::size_t i = 0; i < 3; ++i) {
    marker.offset_m[i] = (*numbers)[i];
    if (!(std::abs((*numbers)[i]) < 10)) {
      map.error(map.line_of_key("offset_m"), "offset_m", fmt::format("{} is not within 10 m", (*numbers)[i]));
    }
  }
}

// kMinRingRatio_q16 and kMaxRingRatio_q16 of core/vision/detector.hpp, which tools may not include.
constexpr double kMinRingRatio = 0.1875, kMaxRingRatio = 0.75;

/// Inner : outer diameter; 0 where either is missing.
double ring_ratio(const Marker& marker) {
  return marker.outer_diameter_m > 0 ? marker.inner_diameter_m / marker.outer_diameter_m : 0;
}

void read_ring(YamlMap& map, Marker& marker) {
  map.check_keys({"frame", "type", "outer_diameter_m", "inner_diameter_m", "offset_m"}, YamlMap::UnknownKeys::refuse);
  marker.kind = model::MarkerKind::ring;
  marker.outer_diameter_m = read_diameter(map, "outer_diameter_m");
  marker.inner_diameter_m = read_diameter(map, "inner_diameter_m");
  if (marker.outer_diameter_m > 0 && marker.inner_diameter_m >= marker.outer_diameter_m) {
    map.error(map.line_of_key("inner_diameter_m"), "inner_diameter_m", "is not smaller than outer_diameter_m");
  } else if (const double ratio = ring_ratio(marker); ratio > 0 && (ratio < kMinRingRatio || ratio > kMaxRingRatio)) {
    map.error(map.line_of_key("inner_diameter_m"), "inner_diameter_m",
              fmt::format("is {:.3g} of outer_diameter_m; the detector finds rings of {} to {}", ratio, kMinRingRatio,
                          kMaxRingRatio));
  }
}

void read_dot(YamlMap& map, Marker& marker) {
  map.check_keys({"frame", "type", "diameter_m", "polarity", "offset_m"}, YamlMap::UnknownKeys::refuse);
  marker.outer_diameter_m = read_diameter(map, "diameter_m");
  const auto polarity = map.text("polarity");
  if (polarity == "light_on_dark") {
    marker.kind = model::MarkerKind::dot_light_on_dark;
  } else if (polarity == "dark_on_light") {
    marker.kind = model::MarkerKind::dot_dark_on_light;
  } else if (polarity) {
    map.error(map.line_of_key("polarity"), "polarity", "is neither light_on_dark nor dark_on_light");
  }
}

Marker read_marker(YamlMap& map) {
  Marker marker;
  marker.line = map.line();
  marker.frame = marker.name = map.text("frame").value_or("");
  const auto type = map.text("type");
  if (type == "ring") {
    read_ring(map, marker);
  } else if (type == "dot") {
    read_dot(map, marker);
  } else if (type) {
    map.error(map.line_of_key("type"), "type", fmt::format("'{}' is neither ring nor dot", *type));
  }
  read_offset(map, marker);
  return marker;
}

/// The detector searches for rings of one ratio.
void check_one_ratio(const MarkersFile& file, Diagnostics& diagnostics) {
  constexpr double kRounding = 0.01;  // a person types two or three digits
  const Marker* first = nullptr;
  for (const Marker& marker : file.markers) {
    if (marker.kind != model::MarkerKind::ring || ring_ratio(marker) == 0) continue;
    if (first == nullptr) first = &marker;
    if (std::abs(ring_ratio(marker) - ring_ratio(*first)) <= kRounding * ring_ratio(*first)) continue;
    diagnostics.error(file.file, marker.line, title("marker", marker.name),
                      fmt::format("its ratio of inner to outer diameter is {:.3g}, but {:.3g} in line {}; all rings of "
                                  "a model need the same",
                                  ring_ratio(marker), ring_ratio(*first), first->line));
  }
}

}  // namespace

std::optional<MarkersFile> read_markers(const SourceFile& source, Diagnostics& diagnostics) {
  const auto document = read_yaml(source, diagnostics);
  if (!document) return std::nullopt;
  YamlMap top(source, *document, "", diagnostics);
  top.check_keys({"markers", "q0"}, YamlMap::UnknownKeys::refuse);

  MarkersFile result;
  result.file = source.path;
  const YAML::Node list = top.get("markers");
  if (list.IsDefined() && list.IsSequence()) {
    for (const auto& item : list) {
      YamlMap map(source, item, fmt::format("marker {}", result.markers.size() + 1), diagnostics);
      result.markers.push_back(read_marker(map));
    }
  } else {
    top.error(top.line_of_key("markers"), "markers", "is not a list of markers");
  }
  check_one_ratio(result, diagnostics);
  if (top.has("q0")) {
    result.q0 = top.numbers("q0", 0);
    result.q0_line = top.line_of_key("q0");
  }
  return result;
}

}  // namespace articam::modelgen
