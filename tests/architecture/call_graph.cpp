#include "tests/architecture/call_graph.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <sstream>

namespace articam::architecture {
namespace {

/// The text between `key: "` and the next quote.
std::optional<std::string> quoted(std::string_view line, std::string_view key) {
  const std::string begin = std::string{key} + ": \"";
  const std::size_t at = line.find(begin);
  if (at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at + begin.size());
  const std::size_t end = line.find('"');
  if (end == std::string_view::npos) return std::nullopt;
  return std::string{line.substr(0, end)};
}

std::vector<std::string> split_label(std::string_view label) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = label.find("\\n");
    parts.emplace_back(label.substr(0, end));
    if (end == std::string_view::npos) return parts;
    label.remove_prefix(end + 2);
  }
}

/// What the compiler may call on its own, and the one function of libm that IEEE 754 rounds.
bool is_library(std::string_view name) {
  constexpr std::array kNames{"memcpy", "memmove", "memset", "memcmp", "sqrt", "sqrtf", "__stack_chk_fail"};
  constexpr std::array kArithmetic{"__aeabi_", "__popcount", "__ctz", "__clz", "__div", "__udiv", "__mod", "__umod"};
  return std::ranges::count(kNames, name) != 0 ||
         std::ranges::any_of(kArithmetic, [name](std::string_view begin) { return name.starts_with(begin); });
}

std::string without_file(const std::string& name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string::npos ? name : name.substr(colon + 1);
}

}  // namespace

bool CallGraph::read(const std::string& text) {
  if (!text.starts_with("graph: {")) return false;
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("edge:")) {
      const auto caller = quoted(line, "sourcename"), callee = quoted(line, "targetname");
      if (!caller || !callee) return false;
      functions_[*caller].calls.push_back(*callee);
    } else if (line.starts_with("node:")) {
      const auto name = quoted(line, "title"), label = quoted(line, "label");
      if (!name || !label) return false;
      const auto parts = split_label(*label);
      Function& function = functions_[*name];
      if (function.readable.empty()) function.readable = parts.front();
      for (const std::string& part :
           parts) {  // `40 bytes (static)`; `(dynamic,bounded)` is a maximum too, `(dynamic)` is not
        const std::size_t unit = part.find(" bytes (");
        if (unit == std::string::npos) continue;
        long bytes = 0;
        if (std::from_chars(part.data(), part.data() + unit, bytes).ec != std::errc{}) return false;
        function.frame_bytes = std::max(function.frame_bytes, bytes);
        function.dynamic |= part.substr(unit) == " bytes (dynamic)";
        files_of_.emplace(without_file(*name), *name);
      }
    }
  }
  return true;
}

std::map<std::string, std::string> CallGraph::find(std::string_view words) const {
  std::map<std::string, std::string> found;
  for (const auto& [name, function] : functions_) {
    if (function.frame_bytes >= 0 && function.readable.find(words) != std::string::npos)
      found[function.readable] = name;
  }
  return found;
}

const CallGraph::Function* CallGraph::definition(const std::string& name) const {
  if (const auto here = functions_.find(name); here != functions_.end() && here->second.frame_bytes >= 0) {
    return &here->second;
  }
  std::string symbol = without_file(name);
  if (const auto elsewhere = files_of_.find(symbol); elsewhere != files_of_.end())
    return &functions_.at(elsewhere->second);
  // A class without virtual bases has one constructor under two names, of which the graph defines one.
  const std::size_t constructor = symbol.rfind("C1E");
  if (constructor == std::string::npos) return nullptr;
  const auto alias = files_of_.find(symbol.replace(constructor, 3, "C2E"));
  return alias == files_of_.end() ? nullptr : &functions_.at(alias->second);
}

/// Depth first; the deepest chain below a function is found once.
class CallGraph::Walk {
 public:
  explicit Walk(const CallGraph& graph) : graph_{graph} {}

  WorstCase from(const std::string& name) {
    WorstCase worst;
    worst.bytes = depth(name);
    for (std::string at = name; !at.empty(); at = deepest_[at]) worst.path.push_back(frame(at));
    worst.violations.assign(violations_.begin(), violations_.end());
    return worst;
  }

 private:
  std::string readable(const std::string& name) const {
    const Function* function = graph_.definition(name);
    return function != nullptr ? function->readable : name;
  }
  std::string frame(const std::string& name) const {
    const Function* function = graph_.definition(name);
    return std::to_string(function != nullptr ? function->frame_bytes : kLibraryFrame_bytes) + "  " + readable(name);
  }

  long depth(const std::string& name) {
    const Function* function = graph_.definition(name);
    if (function == nullptr) {
      if (name == "__indirect_call")
        violations_.insert("call through a pointer, in " + readable(callers_.back()));
      else if (!is_library(name))
        violations_.insert("nobody defines " + name);
      return kLibraryFrame_bytes;
    }
    if (std::ranges::count(callers_, name) != 0) {
      violations_.insert("recursion: " + function->readable);
      return 0;
    }
    if (const auto known = bytes_.find(name); known != bytes_.end()) return known->second;
    if (function->dynamic) violations_.insert("frame of a size that only run time knows: " + function->readable);
    callers_.push_back(name);
    long below = 0;
    std::string& deepest = deepest_[name];
    for (const std::string& callee : function->calls) {
      if (const long bytes = depth(callee); bytes > below) below = bytes, deepest = callee;
    }
    callers_.pop_back();
    return bytes_[name] = function->frame_bytes + below;
  }

  const CallGraph& graph_;
  std::vector<std::string> callers_;
  std::map<std::string, long> bytes_;
  std::map<std::string, std::string> deepest_;
  std::set<std::string> violations_;
};

WorstCase CallGraph::worst_case(const std::string& name) const { return Walk{*this}.from(name); }

}  // namespace articam::architecture
