/// @file  articam-estimator-table: how well the estimator does what is asked of it, item by item.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/bench/estimator_table/table.hpp"

namespace {

using namespace articam::estimator_table;

struct Item {
  const char* name;
  const char* title;
  void (*measure)(const Run&, Table&);
};

constexpr Item kItems[] = {
    {"crb", "Root mean square errors against the Cramer-Rao bound: one frame, centres only", crb},
    {"nees", "The covariance: normalised squared error, 8 where it is true", nees},
    {"outliers", "Marks that lie, 0.02 px", outliers},
    {"convergence", "Starts that converge", convergence},
    {"hidden", "The drawer's marks hidden for 2 s while it moves, 0.02 px, centres only", hidden},
    {"flips", "Nearly fronto-parallel, 60 s", flips},
    {"moving", "A moving drawer, 0.02 px, centres only", moving},
    {"shape", "Size and shape: rendered frames, fronto-parallel at 0.7 m", shape},
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Measures the estimator on the printer of 640 x 480, f = 525 px, 30 frames a second, and prints what came out\n"
      "beside what is asked for, as markdown tables; what misses its target is bold. Frames are the exact images of "
      "the\n"
      "marks with Gaussian noise, their variances told truly (so the tracker's floor_px is 0), but for those that are\n"
      "rendered and detected. Half a minute in full.\n\n"
      "Example:  articam-estimator-table --only crb --only nees > table.md",
      "articam-estimator-table"};
  app.set_version_flag("--version", ARTICAM_VERSION);
  Run run{.trials = 20000, .seed = 1};
  std::vector<std::string> only, names;
  for (const Item& item : kItems) names.emplace_back(item.name);
  app.add_option("--trials", run.trials, "of crb; the other items take their part of it")
      ->check(CLI::Range(100, 10000000))
      ->capture_default_str();
  app.add_option("--seed", run.seed, "of noise, starts and views")->capture_default_str();
  app.add_option("--only", only, "this item alone; may be given again")->check(CLI::IsMember(names));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  int rows = 0, met = 0;
  for (const Item& item : kItems) {
    if (!only.empty() && std::ranges::find(only, item.name) == only.end()) continue;
    fmt::print(stderr, "{}\n", item.name);
    Table table{item.title};
    item.measure(run, table);
    rows += table.rows(), met += table.met();
  }
  fmt::print("\n{} of {} targets are met. Trials {}, seed {}.\n", met, rows, run.trials, run.seed);
  return met == rows ? 0 : 1;
}
