// articam-probe: the kinematics of a model, for scripts and for checking a table against other software.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <string>

#include "static_models/registry.hpp"
#include "tools/command_line.hpp"
#include "tools/probe/model_probe.hpp"

namespace {

using articam::tools::kDone, articam::tools::kWrongUsage;

void declare(CLI::App& app, std::string& name, bool& list) {
  app.footer(std::string(articam::probe::kLines) +
             "Example: the drawer open by 8 cm, its second marker 12 cm from the first\n"
             "  echo 0.08 0.12 | articam-probe printer_drawer\n"
             "Exit codes: 0 done, 1 a line is not a set of joint values, 2 wrong usage.");
  app.set_version_flag("--version", "articam-probe " ARTICAM_VERSION);
  app.add_option("model", name, "Folder of static_models")->type_name("MODEL");
  app.add_flag("--list", list, "Name the models");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Where the markers of a model are, and how its joints move them."};
  std::string name;
  bool list = false;
  declare(app, name, list);
  if (const auto exit_code = articam::tools::parse(app, argc, argv)) return *exit_code;
  if (list) {
    for (const auto model : articam::models::kStaticModelNames) std::printf("%s\n", std::string(model).c_str());
    return kDone;
  }
  int exit_code = kWrongUsage;
  const auto run = [&]<class Model>() { exit_code = articam::probe::run<Model>(std::cin, stdout, stderr); };
  if (!articam::models::visit_model(name, run)) {
    std::fprintf(stderr, "MODEL: '%s' is not a static model; --list names them\n", name.c_str());
  }
  return exit_code;
}
