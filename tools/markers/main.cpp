// articam-markers: the markers of a model, at true scale on paper.
#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "static_models/registry.hpp"
#include "tools/command_line.hpp"
#include "tools/markers/layout.hpp"
#include "tools/markers/mark.hpp"
#include "tools/markers/options.hpp"
#include "tools/markers/sheet_files.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/output_files.hpp"
#include "tools/modelgen/source_file.hpp"

namespace {

using namespace articam;
using namespace articam::markers;
using namespace articam::tools;

struct MarkedModel {
  std::string name;
  std::vector<Mark> marks;
};

int fail(int exit_code, const std::string& message) {
  fmt::print(stderr, "articam-markers: {}\n", message);
  return exit_code;
}

std::string counted(std::size_t number, const char* thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::optional<MarkedModel> static_model(const std::string& name) {
  std::optional<MarkedModel> found;
  models::visit_model(name, [&]<class Model>() { found = {std::string{Model::kName}, marks_of(Model::kMarkers)}; });
  return found;
}

/// What the model compiler has to say goes to stderr; nothing when it refuses a file.
std::optional<MarkedModel> model_of_files(const Options& options) {
  constexpr const char* kTypeName = "Sheet";  // names the C++ struct of a header that is not written
  modelgen::Diagnostics diagnostics;
  const auto urdf = modelgen::read_source(options.urdf, diagnostics);
  const auto markers = modelgen::read_source(options.markers, diagnostics);
  std::optional<modelgen::CompiledModel> model;
  if (urdf && markers) model = modelgen::compile_model({*urdf, markers, kTypeName, options.modelling}, diagnostics);
  fmt::print(stderr, "{}", diagnostics.text());
  if (!model) return std::nullopt;
  return MarkedModel{model->table.robot, marks_of(model->table.markers)};
}

int write_sheets(const Options& options, const MarkedModel& model) {
  if (model.marks.empty()) return fail(kRefused, fmt::format("'{}' has no markers to print", model.name));
  const auto sheets = lay_out(model.marks, options.paper, options.margin_mm);
  if (!sheets) {
    for (const auto& reason : objections(model.marks, options.paper, options.margin_mm)) (void)fail(kRefused, reason);
    return kRefused;
  }
  std::string why;
  const auto files = render(*sheets, model.name, options.output, options.format, why);
  if (!files) return fail(kRefused, "drawing: " + why);
  why = modelgen::write_files(*files);
  if (!why.empty()) return fail(kRefused, why);
  for (const auto& file : *files) fmt::print("{}\n", file.path);
  fmt::print("{}, {} of {} {}. Print at 100 %, then measure the ruler.\n", counted(model.marks.size(), "marker"),
             counted(sheets->pages.size(), "page"), sheets->paper.name,
             sheets->paper.landscape() ? "landscape" : "portrait");
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (const auto exit_code = parse_options(argc, argv, options)) return *exit_code;
  if (options.list) {
    for (const auto name : models::kStaticModelNames) fmt::print("{}\n", name);
    return kDone;
  }
  const auto model = options.model.empty() ? model_of_files(options) : static_model(options.model);
  if (model) return write_sheets(options, *model);
  if (options.model.empty()) return kRefused;
  return fail(kWrongUsage, fmt::format("MODEL: '{}' is not a static model; --list names them", options.model));
}
