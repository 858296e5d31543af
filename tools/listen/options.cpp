#include "tools/listen/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "tools/command_line.hpp"
#include "tools/listen/json_output.hpp"
#include "tools/listen/source.hpp"

namespace articam::listen {
namespace {

constexpr const char* kExamples = R"(
Examples
  articam-listen                                  the group that a board sends to when nobody says otherwise
  articam-listen --udp 47047                      what is sent to that port of this machine
  articam-listen --udp 239.1.1.1:47047            what is sent to a group; ?via=10.0.0.5 chooses the interface
  articam-listen --serial /dev/ttyUSB0?baud=115200
  articam-listen --quiet --csv est.csv --mcap run.mcap --seconds 60
  articam-listen --quiet --json-udp               for PlotJuggler: UDP Server, port 9870, json, field timestamp
  articam-listen --once --timeout 5               does the board send?

Joints are in rad or, where they slide, in m; poses in m, x right, y down, z forward of the camera. Files hold what was
heard up to the last estimate, even if the program is killed.
Exit codes: 0 done, 1 nothing (or fewer than --count) was heard or an output failed, 2 wrong usage.)";

struct Texts {
  std::string udp, serial, json;
  bool once{};
};

void declare_input(CLI::App& app, Texts& texts, Options& out) {
  auto* udp = app.add_option("--udp", texts.udp, "listen there (default: the board's group, 239.255.47.47:47047)");
  udp->type_name("[GROUP:]PORT");
  app.add_option("--serial", texts.serial, "listen on a serial line")->type_name("DEVICE")->excludes(udp);
  auto* key = app.add_option("--key", out.key, "take only packets that the holder of this key has made");
  key->type_name("FILE");
  app.add_option("--key-state", out.key_state, "remember there, over restarts, which packets have come")
      ->type_name("FILE")
      ->needs(key);
}

void declare_outputs(CLI::App& app, Texts& texts, Options& out) {
  app.add_option("--csv", out.csv, "record rows as articam-replay writes them")->type_name("FILE");
  app.add_option("--t0", out.csv_from_first, "t_s of the CSV: on the board's clock, or since the first estimate")
      ->transform(CLI::CheckedTransformer(std::map<std::string, bool>{{"board", false}, {"first", true}}))
      ->option_text("board|first");
  app.add_option("--mcap", out.mcap, "record ROS 2 messages")->type_name("FILE");
  app.add_flag("--overwrite", out.overwrite, "let --csv and --mcap replace a file");
  app.add_option("--json-udp", texts.json, "forward JSON (default: 127.0.0.1:9870)")
      ->option_text("[[ADDRESS:]PORT]")
      ->expected(0, 1);
  app.add_flag("--quiet", out.quiet, "print no estimates");
  app.add_flag("--stats", out.stats, "print latency and loss every second");
}

void declare_end(CLI::App& app, Texts& texts, Options& out) {
  auto* once = app.add_flag("--once", texts.once, "end after one estimate");
  app.add_option("--count", out.count, "end after so many estimates")->excludes(once)->check(CLI::PositiveNumber);
  app.add_option("--seconds", out.seconds, "end after this time")->check(CLI::PositiveNumber);
  app.add_option("--timeout", out.timeout_s, "end when nothing comes for so many seconds")->check(CLI::PositiveNumber);
}

/// Empty, or why it is no address to send JSON to.
std::string parse_json(const std::string& text, std::optional<wire::Address>& out) {
  std::string address = text.find('.') == std::string::npos ? "127.0.0.1:" + text : text;
  if (address.ends_with(':')) address.pop_back();
  if (address.find(':') == std::string::npos) address += fmt::format(":{}", kPlotJugglerPort);
  return parse_udp(address, out.emplace());
}

/// Empty, or what is wrong with the usage.
std::string parse_texts(const CLI::App& app, const Texts& texts, Options& out) {
  const auto wrong = [](const char* option, const std::string& why) {
    return why.empty() ? why : fmt::format("{}: {}\nRun with --help for more information.", option, why);
  };
  std::string problem;
  if (app.count("--udp") + app.count("--serial") == 0) (void)wire::parse_address(wire::kDefaultAddress, out.from);
  if (app.count("--udp") > 0) problem = wrong("--udp", parse_udp(texts.udp, out.from));
  if (app.count("--serial") > 0) problem = wrong("--serial", parse_serial(texts.serial, out.from));
  if (app.count("--json-udp") > 0 && problem.empty()) problem = wrong("--json-udp", parse_json(texts.json, out.json));
  return problem;
}

}  // namespace

std::optional<int> parse_options(int argc, const char* const* argv, Options& out) {
  CLI::App app{"Receives the estimates that a board sends; prints, records and forwards them.", "articam-listen"};
  Texts texts;
  app.footer(kExamples);
  app.set_version_flag("--version", "articam-listen " ARTICAM_VERSION);
  declare_input(app, texts, out);
  declare_outputs(app, texts, out);
  declare_end(app, texts, out);
  if (const auto exit_code = tools::parse(app, argc, argv)) return exit_code;
  if (texts.once) out.count = 1;
  const std::string problem = parse_texts(app, texts, out);
  if (problem.empty()) return std::nullopt;
  std::fputs(("articam-listen: " + problem + '\n').c_str(), stderr);
  return kWrongUsage;
}

}  // namespace articam::listen
