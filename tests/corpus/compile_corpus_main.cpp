// compile_corpus OUT PER_SOURCE FILE.urdf...: every URDF, with a point at each leaf link, to OUT/STEM.hpp; what became
// of PER_SOURCE of them at a time to OUT/corpus_N.cpp; and OUT/corpus.cpp, which lists them.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

#include "core/model/table_hash.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/emit_rows.hpp"
#include "tools/modelgen/output_files.hpp"
#include "tools/modelgen/read_urdf.hpp"

namespace {

using namespace articam::modelgen;

ModelOptions points_at_leaves(const SourceFile& source) {
  ModelOptions options;
  Diagnostics ignored;  // the compiler says it again
  const auto model = read_urdf(source, ignored);
  if (!model) return options;
  std::set<std::string> parents;
  for (const UrdfJoint& joint : model->joints) parents.insert(joint.parent);
  for (const UrdfLink& link : model->links) {
    if (parents.count(link.name) > 0) continue;
    Marker point;
    point.name = point.frame = link.name;
    options.points.push_back(point);
  }
  return options;
}

/// `line: element: reason` of the first error.
std::string first_error(const Diagnostics& diagnostics) {
  for (const Message& message : diagnostics.messages()) {
    if (message.severity == Severity::error) {
      return fmt::format("{}: {}: {}", message.line, message.element, message.reason);
    }
  }
  return "";
}

std::uint64_t hash_of(const std::string& text) {
  articam::model::Fnv1a hash;
  hash.put(std::string_view(text));
  return hash.value();
}

struct Entry {
  std::string header, source;
};

/// One file's header, empty where there is none, and the lines that define `entry_N`.
Entry compile(const std::filesystem::path& path, std::size_t number) {
  Diagnostics diagnostics;
  const auto source = read_source(path.string(), diagnostics);
  const std::string type = fmt::format("Corpus{}", number);
  std::optional<CompiledModel> model;
  if (source) model = compile_model({*source, {}, type, points_at_leaves(*source)}, diagnostics);
  const std::string entry =
      fmt::format("extern const articam::test::CorpusFile entry_{}{{{},", number, literal(path.filename().string()));
  if (!model) return {"", fmt::format("{} {}, 0, nullptr}};\n", entry, literal(first_error(diagnostics)))};
  return {model->header, fmt::format("#include {}\n{} \"\", {}u, articam::test::evaluate<articam::models::{}>}};\n",
                                     literal(path.stem().string() + ".hpp"), entry, hash_of(model->header), type)};
}

std::string list_entries(std::size_t count) {
  std::string externs, names;
  for (std::size_t i = 0; i < count; ++i) {
    externs += fmt::format("extern const articam::test::CorpusFile entry_{};\n", i);
    names += fmt::format("entry_{}, ", i);
  }
  return fmt::format(
      "#include \"tests/corpus/corpus.hpp\"\n{}std::span<const articam::test::CorpusFile> articam::test::corpus() {{\n"
      "  static const std::array<CorpusFile, {}> files{{{}}};\n  return files;\n}}\n",
      externs, count, names);
}

bool write(const std::filesystem::path& path, const std::string& text) {
  const std::string problem = write_files({{path.string(), text}});
  if (!problem.empty()) std::fprintf(stderr, "%s\n", problem.c_str());
  return problem.empty();
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path out = argv[1];
  const auto per_source = static_cast<std::size_t>(std::stoi(argv[2]));
  const std::vector<std::filesystem::path> files(argv + 3, argv + argc);
  bool written = write(out / "corpus.cpp", list_entries(files.size()));
  std::string source;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i % per_source == 0) source = "#include \"tests/corpus/corpus.hpp\"\n";
    const Entry entry = compile(files[i], i);
    source += entry.source;
    if (!entry.header.empty()) written = write(out / files[i].stem().concat(".hpp"), entry.header) && written;
    const bool full = (i + 1) % per_source == 0 || i + 1 == files.size();
    if (full) written = write(out / fmt::format("corpus_{}.cpp", i / per_source), source) && written;
  }
  return written ? 0 : 1;
}
