#include "tests/architecture/source_tree.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace articam::architecture {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFolders{"core",  "hal",       "host_sim", "static_models", "tools", "tests",
                              "cmake", "toolchain", ".ci"};
constexpr std::array kExtensions{".hpp", ".cpp", ".cmake", ".txt", ".sh", ".md", ".yaml", ".urdf", ".json", ""};

bool is_written_by_people(const fs::path& path) {
  return std::ranges::count(kExtensions, path.extension().string()) != 0 &&
         path.generic_string().find("/data/") == std::string::npos;
}

void add_if_written_by_people(const fs::path& root, const fs::directory_entry& entry, std::vector<SourceFile>& files) {
  const fs::path path = entry.path().lexically_relative(root);
  if (!entry.is_regular_file() || !is_written_by_people(path)) return;
  std::ifstream in{entry.path(), std::ios::binary};
  files.push_back({path.generic_string(), {std::istreambuf_iterator<char>{in}, {}}});
}

}  // namespace

std::vector<SourceFile> read_source_tree() {
  const fs::path root = ARTICAM_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const auto& entry : fs::directory_iterator{root}) add_if_written_by_people(root, entry, files);
  for (const char* folder : kFolders) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator{root / folder}) {
      add_if_written_by_people(root, entry, files);
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::string to_string(const Violations& violations) {
  std::string text;
  for (const auto& [path, line, reason] : violations) text += path + ":" + std::to_string(line) + ": " + reason + "\n";
  return text;
}

}  // namespace articam::architecture
