#pragma once
/// @file  main() of a probe for one model, which articam_add_probe makes.

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <string>

#include "tools/probe/probe.hpp"

namespace articam::probe {

/// The lines in and out, as every probe's --help has them.
inline constexpr const char* kLines =
    "Prints `joints NAME...`; then for each line of joint values (rad, m) on stdin\n"
    "  marker NAME x y z nx ny nz               centre and outward normal, root frame, m\n"
    "  jac NAME JOINT vx vy vz wx wy wz         twist at that centre per unit joint rate, root frame\n"
    "  end\n"
    "A model without joints answers each empty line. Blanks in a name are printed as _.\n";

struct ProbeTitle {
  const char* name;     ///< of the program
  const char* model;    ///< its C++ type
  const char* version;  ///< of articam
};

/// An example that works: every joint at zero.
template <class Model>
std::string example(const ProbeTitle& title) {
  std::string zeros;
  for (int j = 0; j < model::kNumJoints<Model>; ++j) zeros += zeros.empty() ? "0" : " 0";
  return "Example: every joint at zero\n  echo " + zeros + " | " + title.name + "\n";
}

/// Returns the exit code: 0 done, 1 a line is not a set of joint values, 2 wrong usage.
template <class Model>
int run_program(const ProbeTitle& title, int argc, char** argv) {
  CLI::App app{std::string("Where the markers of ") + title.model + " are, and how its joints move them.", title.name};
  app.footer(kLines + example<Model>(title) +
             "Exit codes: 0 done, 1 a line is not a set of joint values, 2 wrong usage.");
  app.set_version_flag("--version", std::string(title.name) + " (articam " + title.version + ")");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? 0 : 2;
  }
  return run<Model>(std::cin, stdout, stderr);
}

}  // namespace articam::probe
