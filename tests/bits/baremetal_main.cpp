/// @file  articam-bits for a processor without an operating system; see main.cpp.

#include <algorithm>
#include <array>

#include "hal/baremetal/semihosting.hpp"
#include "tests/bits/bits_run.hpp"

namespace {
articam::test::BitsRun run;
std::array<char, 256> storage;
}  // namespace

int main() {
  using namespace articam;
  const bool flip = hal::semihosting::command_line(storage).ends_with(" flip");
  run.run(flip ? test::kEdgeFlip : test::Flip{}, [](const hal::Line& line) { hal::semihosting::write(line.text()); });
  return 0;
}
