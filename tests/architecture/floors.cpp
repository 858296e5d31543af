#include "tests/architecture/floors.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace articam::architecture {
namespace {

enum class System {
  heap_free,  ///< Eigen and the part of std that never allocates
  any         ///< the operating system and host libraries
};

/// A place in the house. A name that ends in '/' is a folder with all below it; "core/*" is the headers
/// of that folder alone; "." is the file's own folder.
struct Room {
  std::string_view place;
  System system;
  std::vector<std::string_view> may_include;
};

using enum System;

// The first match decides, so narrow places stand before wide ones.
const std::vector<Room> kHouse{
    // clang-format off
    {"core/*",               heap_free, {"core/*", "core/math/"}},
    {"core/math/",           heap_free, {"core/*", "core/math/"}},
    {"core/model/",          heap_free, {"core/*", "core/math/", "core/model/"}},
    {"core/vision/",         heap_free, {"core/*", "core/math/", "core/vision/"}},
    {"core/tracker/",        heap_free, {"core/"}},
    {"static_models/",       heap_free, {"core/*", "core/math/", "core/model/", "core/vision/", "static_models/"}},
    {"hal/ports/",           heap_free, {"core/", "hal/ports/"}},
    {"hal/wire/",            heap_free, {"core/", "hal/wire/"}},
    {"hal/run_loop.hpp",     heap_free, {"core/", "hal/ports/"}},
    {"hal/posix/",           any,       {"core/*", "hal/ports/", "hal/wire/", "hal/posix/"}},
    {"hal/capture/",         any,       {"core/*", "hal/capture/"}},
    {"hal/app/",             any,       {"core/", "static_models/", "hal/", "tools/"}},
    {"hal/*",                heap_free, {"core/", "static_models/", "hal/"}},
    {"hal/",                 any,       {"core/", "static_models/", "hal/ports/", "hal/wire/", "hal/posix/",
                                         "hal/capture/", "hal/run_loop.hpp", "."}},
    {"host_sim/main.cpp",    any,       {"core/", "static_models/", "hal/", "tools/", "host_sim/"}},
    {"host_sim/",            any,       {"core/", "static_models/", "hal/ports/", "hal/run_loop.hpp", "host_sim/"}},
    {"tools/listen/",        any,       {"core/*", "core/math/", "hal/wire/", "hal/posix/", "hal/authentication/",
                                         "tools/"}},
    {"tools/identify/",      any,       {"core/*", "core/math/", "core/model/", "core/vision/", "tools/"}},
    {"tools/probe/main.cpp", any,       {"core/*", "core/math/", "core/model/", "static_models/", "tools/"}},
    {"tools/markers/main.cpp", any,     {"core/*", "core/math/", "core/model/", "static_models/", "tools/"}},
    {"tools/",               any,       {"core/*", "core/math/", "core/model/", "tools/"}},
    // clang-format on
};

constexpr std::array<std::string_view, 22> kHeapFree{
    "algorithm", "array",       "bit",     "cfloat",      "chrono",  "climits", "cmath",   "compare",
    "concepts",  "cstddef",     "cstdint", "cstring",     "limits",  "numbers", "numeric", "ratio",
    "span",      "string_view", "tuple",   "type_traits", "utility", "version"};

std::string_view folder_of(std::string_view path) { return path.substr(0, path.rfind('/') + 1); }

bool lies_in(std::string_view path, std::string_view place) {
  if (place.ends_with("/*")) return folder_of(path) == place.substr(0, place.size() - 1);
  return place.ends_with('/') ? path.starts_with(place) : path == place;
}

struct Include {
  bool quoted{};
  std::string_view target;
};

std::optional<Include> parse_include(std::string_view line) {
  const auto skip_blanks = [&line] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip_blanks();
  if (!line.starts_with('#')) return std::nullopt;
  line.remove_prefix(1);
  skip_blanks();
  constexpr std::string_view kWord = "include";
  if (!line.starts_with(kWord)) return std::nullopt;
  line.remove_prefix(kWord.size());
  skip_blanks();
  const bool quoted = line.starts_with('"');
  if (!quoted && !line.starts_with('<')) return Include{true, line};  // a macro: refused, it hides its target
  line.remove_prefix(1);
  return Include{quoted, line.substr(0, line.find(quoted ? '"' : '>'))};
}

/// Why this room may not include that; nothing when it may.
std::optional<std::string> objection(const Room& room, std::string_view path, const Include& include) {
  const std::string target{include.target};
  if (!include.quoted) {
    if (target.starts_with("opencv2/")) return "<" + target + "> is for tests and benches only";
    const bool allowed = target.starts_with("Eigen/") || std::ranges::count(kHeapFree, include.target) != 0;
    if (room.system == System::heap_free && !allowed) return "<" + target + "> is not in the heap-free part of std";
    return std::nullopt;
  }
  for (const std::string_view place : room.may_include) {
    if (place == "." ? lies_in(target, folder_of(path)) : lies_in(target, place)) return std::nullopt;
  }
  const bool from_the_root =
      std::ranges::any_of(kHouse, [&](const Room& other) { return lies_in(target, other.place); }) ||
      target.starts_with("tests/");
  if (!from_the_root) return "\"" + target + "\" is not written from the root";
  return std::string{room.place} + " may not include \"" + target + "\"";
}

}  // namespace

Violations check_includes(std::string_view path, std::string_view text) {
  if (!path.ends_with(".hpp") && !path.ends_with(".cpp")) return {};
  const auto room = std::ranges::find_if(kHouse, [&](const Room& r) { return lies_in(path, r.place); });
  if (room == kHouse.end()) return {};
  Violations violations;
  int number = 0;
  for (const std::string_view line : lines_of(text)) {
    ++number;
    const auto include = parse_include(line);
    if (!include) continue;
    if (auto reason = objection(*room, path, *include)) violations.push_back({std::string{path}, number, *reason});
  }
  return violations;
}

}  // namespace articam::architecture
