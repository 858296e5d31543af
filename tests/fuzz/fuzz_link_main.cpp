// articam-fuzz-link: millions of damaged packets for the decoders of the link.
#include <CLI/CLI.hpp>

#include <cinttypes>
#include <cstdio>

#include "tests/fuzz/link_laws.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Feeds damaged packets, messages and serial streams to the decoders and holds them to their laws."};
  std::uint64_t inputs = 20'000, seed = 1;
  app.add_option("--inputs", inputs, "How many")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--seed", seed, "The same seed gives the same inputs on every machine")->capture_default_str();
  app.set_version_flag("--version", "articam-fuzz-link " ARTICAM_VERSION);
  app.footer(
      "Build it with the preset sanitize: then every read out of bounds ends it too (tools/fuzz_link.sh).\n"
      "Example: a million inputs of another seed\n"
      "  articam-fuzz-link --inputs 1000000 --seed 7\n"
      "Exit codes: 0 every law held, 1 one was broken, 2 wrong usage.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? 0 : 2;
  }
  articam::fuzz::LinkLaws laws{seed};
  for (std::uint64_t i = 0; i < inputs; ++i) {
    const std::string broken = laws.try_one();
    if (broken.empty()) continue;
    std::fprintf(stderr, "seed %" PRIu64 ", input %" PRIu64 ": %s\n", seed, i, broken.c_str());
    return 1;
  }
  const auto& tally = laws.tally();
  std::printf("%" PRIu64 " inputs of seed %" PRIu64 ": every law held\n", tally.inputs, seed);
  std::printf("  %-16s %10" PRIu64 "\n  %-16s %10" PRIu64 "\n", "messages taken", tally.accepted, "serial frames",
              tally.frames);
  for (int i = 1; i < articam::wire::kNumFaults; ++i) {
    const auto fault = static_cast<articam::wire::Fault>(i);
    const auto count = tally.faults[static_cast<std::size_t>(i)];
    if (count > 0) std::printf("  %-16s %10" PRIu64 "\n", std::string{articam::wire::name(fault)}.c_str(), count);
  }
  return 0;
}
