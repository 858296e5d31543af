// articam-listen: what a board sends -> lines, CSV, MCAP, JSON; and how well it came.
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
#include "tools/listen/options.hpp"
#include "tools/listen/outputs.hpp"

namespace {

using namespace articam::listen;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

volatile std::sig_atomic_t stop_asked = 0;

/// Empty, or why one of them cannot be opened.
std::string open_outputs(const Options& options, Outputs& out) {
  auto csv = std::make_unique<RecordFile>(), mcap = std::make_unique<RecordFile>();
  std::string problem;
  if (!options.csv.empty()) problem = csv->create(options.csv, options.overwrite);
  if (!options.mcap.empty() && problem.empty()) problem = mcap->create(options.mcap, options.overwrite);
  if (!problem.empty()) return problem;
  if (!options.quiet) out.add(std::make_unique<LineOutput>());
  if (!options.csv.empty()) out.add(std::make_unique<CsvOutput>(std::move(csv), options.csv_from_first));
  if (!options.mcap.empty()) out.add(std::make_unique<McapOutput>(std::move(mcap)));
  if (!options.json) return {};
  auto json = std::make_unique<JsonOutput>();
  problem = json->open(*options.json);
  out.add(std::move(json));
  return problem;
}

/// False when standard output takes no more. fmt::print would throw.
bool print(const std::string& text) { return std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0; }

/// Until it is asked to stop, has enough or has waited long enough.
void listen(const Options& options, Source& source, Listener& listener, const Outputs& outputs) {
  constexpr std::chrono::milliseconds kTurn{50};
  const auto start = Clock::now();
  auto heard = start, told = start;
  std::uint64_t taken = 0;
  while (stop_asked == 0 && source.problem().empty() && !outputs.all_failed()) {
    if (const auto received = source.receive(kTurn)) listener.take(*received);
    listener.set_broken_frames(source.broken_frames());
    const auto now = Clock::now();
    if (outputs.taken() != taken) taken = outputs.taken(), heard = now;
    if (options.count > 0 && taken >= options.count) break;
    if (options.seconds > 0 && now - start >= Seconds{options.seconds}) break;
    if (options.timeout_s > 0 && now - heard >= Seconds{options.timeout_s}) break;
    if (options.stats && now - told >= Seconds{1}) {
      told = now;
      print(status_line(listener.statistics()));
    }
  }
}

int fail(int exit_code, const std::string& message) {
  std::fputs(("articam-listen: " + message + '\n').c_str(), stderr);
  return exit_code;
}

int run(const Options& options) {
  std::shared_ptr<articam::wire::Verifier> verifier;
  if (!options.key.empty()) {
    std::string problem;
    verifier = make_verifier(options.key, options.key_state, problem);
    if (verifier == nullptr) return fail(kFailed, problem);
  }
  Source source;
  if (const auto problem = source.open(options.from); !problem.empty()) return fail(kFailed, problem);
  Outputs outputs;
  if (const auto problem = open_outputs(options, outputs); !problem.empty()) return fail(kFailed, problem);
  const auto deliver = [&](const Heard& heard) {
    if (options.count == 0 || outputs.taken() < options.count) outputs.take(heard);
  };
  Listener listener{deliver, verifier.get()};
  listen(options, source, listener, outputs);
  outputs.finish();
  if (!print(table(listener.statistics()))) {
    return fail(kFailed, std::string{"standard output: "} + std::strerror(errno));
  }
  if (!source.problem().empty()) return fail(kFailed, source.problem());
  if (outputs.failed()) return kFailed;
  if (stop_asked != 0) return kDone;
  if (outputs.taken() == 0) {
    return fail(kFailed, "nothing was heard: does the board send here, and does a firewall let it?");
  }
  return outputs.taken() < options.count ? fail(kFailed, "fewer estimates came than --count asks for") : kDone;
}

void install_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { stop_asked = 1; };
  action.sa_flags = SA_RESTART;  // what is being written is written; poll() returns all the same
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an output that fails; the files are still ended
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (const auto exit_code = parse_options(argc, argv, options)) return *exit_code;
  install_signals();
  return run(options);
}
