/// @file  articam-bits: prints the hashes of tests/bits/expected.txt, as this machine computes them.
///
/// `articam-bits flip` flips the lowest bit of one pixel on a ring's edge in frame 50.

#include <cstdio>
#include <memory>
#include <string_view>

#include "tests/bits/bits_run.hpp"

int main(int argc, char** argv) {
  using namespace articam;
  const bool flip = argc == 2 && std::string_view{argv[1]} == "flip";
  if (argc > 1 && !flip) {
    std::fputs("usage: articam-bits [flip]\n", stderr);
    return 2;
  }
  const auto run = std::make_unique<test::BitsRun>();
  run->run(flip ? test::kEdgeFlip : test::Flip{}, [](const hal::Line& line) { std::fputs(line.c_str(), stdout); });
  return std::fflush(stdout) == 0 ? 0 : 1;
}
