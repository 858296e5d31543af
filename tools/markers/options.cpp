#include "tools/markers/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "tools/command_line.hpp"

namespace articam::markers {
namespace {

constexpr const char* kExamples = R"(
Each marker has a quiet zone (a quarter of its diameter), ticks that point to its centre, crop marks, and its name and
diameters below. A page that was scaled by the printer makes every distance wrong: measure its ruler before you glue.

Examples
  articam-markers printer_drawer -o sheet.pdf               a model of static_models; --list names them
  articam-markers --urdf door.urdf --markers door.markers.yaml -o door.pdf --paper letter
  articam-markers printer_drawer -o sheet.svg               an SVG has no pages: sheet-1.svg, sheet-2.svg
Exit codes: 0 done, 1 input refused, 2 wrong usage.)";

struct Texts {
  std::string paper{"A4"};
  std::vector<std::string> freeze;
};

void declare(CLI::App& app, Texts& texts, Options& out) {
  std::vector<std::string> papers;
  for (const Paper& paper : kPapers) papers.emplace_back(paper.name);
  auto* model = app.add_option("model", out.model, "Folder of static_models")->type_name("MODEL");
  auto* urdf = app.add_option("--urdf", out.urdf, "Instead of MODEL: shape of your own object")->type_name("FILE");
  auto* markers = app.add_option("--markers", out.markers, "Markers on its links (YAML)")->type_name("FILE");
  urdf->excludes(model)->needs(markers);
  markers->needs(urdf);
  app.add_option("--root", out.modelling.root, "As for articam-modelgen, which must accept the files")
      ->type_name("LINK")
      ->needs(urdf);
  app.add_option("--freeze", texts.freeze, "Likewise; repeatable")
      ->type_name("JOINT=VALUE")
      ->needs(urdf)
      ->allow_extra_args(false);
  app.add_option("-o,--output", out.output, "Sheet to write, .pdf or .svg")->type_name("FILE");
  app.add_option("--paper", texts.paper, "Upright or on its side, whichever takes fewer pages")
      ->transform(CLI::IsMember(papers, CLI::ignore_case))
      ->capture_default_str();
  app.add_option("--margin", out.margin_mm, "What your printer leaves white, mm")
      ->type_name("MM")
      ->check(CLI::Range(0.0, kMaxMargin_mm))
      ->capture_default_str();
  app.add_flag("--list", out.list, "Name the models");
}

/// Empty, or what is wrong with the usage.
std::string check(const Texts& texts, Options& out) {
  if (out.list) return "";
  if (out.model.empty() && out.urdf.empty()) return "MODEL is required, or --urdf and --markers";
  if (out.output.empty()) return "--output is required";
  const auto format = format_of(out.output);
  if (!format) return fmt::format("--output: '{}' ends neither in .pdf nor in .svg", out.output);
  out.format = *format;
  out.paper = *std::ranges::find(kPapers, texts.paper, &Paper::name);
  for (const std::string& text : texts.freeze) {
    const auto freeze = modelgen::parse_freeze(text);
    if (!freeze) return fmt::format("--freeze: '{}' is not JOINT=VALUE", text);
    out.modelling.freeze.push_back(*freeze);
  }
  return "";
}

}  // namespace

std::optional<int> parse_options(int argc, const char* const* argv, Options& out) {
  CLI::App app{"Draws the markers of a model at true scale, to print, cut out and glue.", "articam-markers"};
  Texts texts;
  app.footer(kExamples);
  app.set_version_flag("--version", "articam-markers " ARTICAM_VERSION);
  declare(app, texts, out);
  if (const auto exit_code = tools::parse(app, argc, argv)) return exit_code;
  const std::string problem = check(texts, out);
  if (problem.empty()) return std::nullopt;
  return tools::wrong_usage(problem);
}

}  // namespace articam::markers
