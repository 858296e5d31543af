/// @file  articam-stack: the worst-case stack of the firmware's loop for every model, one `figure bytes` a line.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "tests/architecture/call_graph.hpp"

namespace {

namespace fs = std::filesystem;
using articam::architecture::CallGraph;

constexpr const char* kUsage =
    "usage: articam-stack FOLDER...\n\n"
    "Reads the call graphs (*.ci) that GCC's -fcallgraph-info=su,da left in the folders, follows every call from\n"
    "RunLoop::run_once of each model, and prints the bytes that the deepest chain needs. The chains themselves go to\n"
    "the standard error. Exit code 1: anywhere in the folders a recursion, a frame of unknown size, a call through a\n"
    "pointer or an unknown callee; or no loop at all.\n";

int read_folder(const fs::path& folder, CallGraph& graph) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator{folder}) {
    if (entry.path().extension() != ".ci") continue;
    std::ifstream in{entry.path(), std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{in}, {}};
    if (!graph.read(text)) std::fprintf(stderr, "%s: not a call graph\n", entry.path().string().c_str());
    ++files;
  }
  return files;
}

/// `PrinterDrawer/float` from `... articam::models::PrinterDrawer ... float>]`; as GCC writes template arguments.
std::string model_and_scalar(const std::string& readable) {
  constexpr std::string_view kBefore = "articam::models::";
  std::string::size_type begin = readable.rfind(kBefore);
  if (begin == std::string::npos) return {};
  begin += kBefore.size();
  const auto end = readable.find_first_of(",;>", begin);
  return readable.substr(begin, end - begin) +
         (readable.find("float", end) != std::string::npos ? "/float" : "/double");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    std::fputs(kUsage, argc < 2 ? stderr : stdout);
    return argc < 2 ? 2 : 0;
  }
  CallGraph graph;
  for (int i = 1; i < argc; ++i) {
    if (read_folder(argv[i], graph) == 0) return std::fprintf(stderr, "%s: no call graphs here\n", argv[i]), 1;
  }
  std::set<std::string> violations;
  for (const auto& [readable, name] : graph.find("articam::")) {
    for (const auto& violation : graph.worst_case(name).violations) violations.insert(violation);
  }
  for (const auto& violation : violations) std::fprintf(stderr, "violation: %s\n", violation.c_str());
  const auto loops = graph.find("Tracker>::run_once()");
  if (loops.empty()) std::fputs("no loop in these graphs\n", stderr);
  for (const auto& [readable, name] : loops) {
    const auto worst = graph.worst_case(name);
    std::printf("loop_stack_bytes/%s %ld\n", model_and_scalar(readable).c_str(), worst.bytes);
    for (const auto& frame : worst.path) std::fprintf(stderr, "  %s\n", frame.c_str());
  }
  return violations.empty() && !loops.empty() ? 0 : 1;
}
