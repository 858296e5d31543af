// articam-listen: what a board sends -> lines, CSV, MCAP, JSON; and how well it came.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "tools/listen/board_key.hpp"
#include "tools/listen/csv_output.hpp"
#include "tools/listen/json_output.hpp"
#include "tools/listen/line_output.hpp"
#include "tools/listen/listener.hpp"
#include "tools/listen/mcap_output.hpp"
#include "tools/listen/outputs.hpp"

namespace {

using namespace articam::listen;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

constexpr const char* kExamples = R"(
Examples
  articam-listen                                  what is sent to port 47047 of this machine
  articam-listen --udp 239.1.1.1:47047            what is sent to a group; ?via=10.0.0.5 chooses the interface
  articam-listen --serial /dev/ttyUSB0?baud=115200
  articam-listen --quiet --csv est.csv --mcap run.mcap --seconds 60
  articam-listen --quiet --json-udp               for PlotJuggler: UDP Server, port 9870, json, field timestamp
  articam-listen --once --timeout 5               does the board send?

Joints are in rad or m, poses in m, x right, y down, z forward of the camera. Files hold what was heard up to the
last estimate, even if the program is killed.
Exit codes: 0 done, 1 nothing (or fewer than --count) was heard or an output failed, 2 wrong usage.)";

struct Arguments {
  std::string udp, serial, key, key_state, csv, mcap, json_udp;
  bool csv_from_first{}, overwrite{}, quiet{}, stats{}, once{};
  std::uint64_t count{};
  double seconds{}, timeout_s{};
};

struct Addresses {
  articam::wire::Address from, json;
};

volatile std::sig_atomic_t stop_asked = 0;

void declare(CLI::App& app, Arguments& arguments) {
  app.footer(kExamples);
  app.set_version_flag("--version", "articam-listen " ARTICAM_VERSION);
  auto* udp = app.add_option("--udp", arguments.udp, "listen there (default: port 47047, every interface)");
  udp->type_name("[GROUP:]PORT");
  app.add_option("--serial", arguments.serial, "listen on a serial line")->type_name("DEVICE")->excludes(udp);
  auto* key = app.add_option("--key", arguments.key, "take only packets that the holder of this key has made");
  key->type_name("FILE");
  app.add_option("--key-state", arguments.key_state, "remember there, over restarts, which packets have come")
      ->type_name("FILE")
      ->needs(key);
  app.add_option("--csv", arguments.csv, "record rows as articam-replay writes them")->type_name("FILE");
  app.add_option("--t0", arguments.csv_from_first, "t_s of the CSV: on the board's clock, or since the first estimate")
      ->transform(CLI::CheckedTransformer(std::map<std::string, bool>{{"board", false}, {"first", true}}))
      ->option_text("board|first");
  app.add_option("--mcap", arguments.mcap, "record ROS 2 messages")->type_name("FILE");
  app.add_flag("--overwrite", arguments.overwrite, "let --csv and --mcap replace a file");
  app.add_option("--json-udp", arguments.json_udp, "forward JSON (default: 127.0.0.1:9870)")
      ->type_name("[ADDRESS:]PORT")
      ->expected(0, 1)
      ->default_str(fmt::format("127.0.0.1:{}", kPlotJugglerPort));
  app.add_flag("--quiet", arguments.quiet, "print no estimates");
  app.add_flag("--stats", arguments.stats, "print latency and loss every second");
  auto* once = app.add_flag("--once", arguments.once, "end after one estimate");
  app.add_option("--count", arguments.count, "end after so many estimates")->excludes(once)->check(CLI::PositiveNumber);
  app.add_option("--seconds", arguments.seconds, "end after this time")->check(CLI::PositiveNumber);
  app.add_option("--timeout", arguments.timeout_s, "end when nothing comes for so many seconds")
      ->check(CLI::PositiveNumber);
}

/// Empty, or what is wrong with the usage.
std::string parse_addresses(const Arguments& arguments, Addresses& out) {
  const bool serial = !arguments.serial.empty();
  if (serial) {
    if (const auto wrong = parse_serial(arguments.serial, out.from); !wrong.empty()) return "--serial: " + wrong;
  } else if (!arguments.udp.empty()) {
    if (const auto wrong = parse_udp(arguments.udp, out.from); !wrong.empty()) return "--udp: " + wrong;
  }
  std::string json = arguments.json_udp;
  if (json.find('.') == std::string::npos) json = "127.0.0.1:" + json;
  if (json.find(':') == std::string::npos) json += fmt::format(":{}", kPlotJugglerPort);
  if (arguments.json_udp.empty()) return {};
  const auto wrong = parse_udp(json, out.json);
  return wrong.empty() ? std::string{} : "--json-udp: " + wrong;
}

/// Empty, or why one of them cannot be opened.
std::string open_outputs(const Arguments& arguments, const Addresses& addresses, Outputs& out) {
  if (!arguments.quiet) out.add(std::make_unique<LineOutput>());
  if (!arguments.csv.empty()) {
    auto file = std::make_unique<RecordFile>();
    if (auto problem = file->create(arguments.csv, arguments.overwrite); !problem.empty()) return problem;
    out.add(std::make_unique<CsvOutput>(std::move(file), arguments.csv_from_first));
  }
  if (!arguments.mcap.empty()) {
    auto file = std::make_unique<RecordFile>();
    if (auto problem = file->create(arguments.mcap, arguments.overwrite); !problem.empty()) return problem;
    out.add(std::make_unique<McapOutput>(std::move(file)));
  }
  if (!arguments.json_udp.empty()) {
    auto json = std::make_unique<JsonOutput>();
    if (auto problem = json->open(addresses.json); !problem.empty()) return problem;
    out.add(std::move(json));
  }
  return {};
}

/// False when standard output takes no more. fmt::print would throw.
bool print(const std::string& text) { return std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0; }

/// Until it is asked to stop, has enough or has waited long enough.
void listen(const Arguments& arguments, Source& source, Listener& listener, const Outputs& outputs) {
  constexpr std::chrono::milliseconds kTurn{50};
  const auto start = Clock::now();
  auto heard = start, told = start;
  std::uint64_t taken = 0;
  while (stop_asked == 0 && source.problem().empty() && !outputs.all_failed()) {
    if (const auto received = source.receive(kTurn)) listener.take(*received);
    listener.set_broken_frames(source.broken_frames());
    const auto now = Clock::now();
    if (outputs.taken() != taken) taken = outputs.taken(), heard = now;
    if (arguments.count > 0 && taken >= arguments.count) break;
    if (arguments.seconds > 0 && now - start >= Seconds{arguments.seconds}) break;
    if (arguments.timeout_s > 0 && now - heard >= Seconds{arguments.timeout_s}) break;
    if (arguments.stats && now - told >= Seconds{1}) {
      told = now;
      print(status_line(listener.statistics()));
    }
  }
}

int fail(int exit_code, const std::string& message) {
  std::fputs(("articam-listen: " + message + '\n').c_str(), stderr);
  return exit_code;
}

int run(const Arguments& arguments, const Addresses& addresses) {
  std::shared_ptr<articam::wire::Verifier> verifier;
  if (!arguments.key.empty()) {
    std::string problem;
    verifier = make_verifier(arguments.key, arguments.key_state, problem);
    if (verifier == nullptr) return fail(kFailed, problem);
  }
  Source source;
  if (const auto problem = source.open(addresses.from); !problem.empty()) return fail(kFailed, problem);
  Outputs outputs;
  if (const auto problem = open_outputs(arguments, addresses, outputs); !problem.empty()) return fail(kFailed, problem);
  const auto deliver = [&](const Heard& heard) {
    if (arguments.count == 0 || outputs.taken() < arguments.count) outputs.take(heard);
  };
  Listener listener{deliver, verifier.get()};
  listen(arguments, source, listener, outputs);
  outputs.finish();
  if (!print(table(listener.statistics())))
    return fail(kFailed, std::string{"standard output: "} + std::strerror(errno));
  if (!source.problem().empty()) return fail(kFailed, source.problem());
  if (outputs.failed()) return kFailed;
  if (stop_asked != 0) return kDone;
  if (outputs.taken() == 0)
    return fail(kFailed, "nothing was heard: does the board send here, and does a firewall let it?");
  return outputs.taken() < arguments.count ? fail(kFailed, "fewer estimates came than --count asks for") : kDone;
}

void install_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { stop_asked = 1; };
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an output that fails; the files are still ended
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Receives the estimates that a board sends; prints, records and forwards them.", "articam-listen"};
  Arguments arguments;
  declare(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? kDone : kWrongUsage;
  }
  if (arguments.once) arguments.count = 1;
  Addresses addresses;
  if (const auto wrong = parse_addresses(arguments, addresses); !wrong.empty()) {
    return fail(kWrongUsage, wrong + "\nRun with --help for more information.");
  }
  install_signals();
  return run(arguments, addresses);
}
