/// @file  Each way in which a program on the board can go wrong, by its name on the command line.

#undef NDEBUG  // eigen_assert as in a debug build
#include <array>
#include <cstdint>
#include <cstdlib>

#include "core/math/types.hpp"
#include "hal/baremetal/fault.hpp"
#include "hal/baremetal/semihosting.hpp"

namespace {

std::array<char, 256> storage;
volatile int deep_enough = 1 << 30;

[[gnu::noinline]] int descend(int depth) {
  volatile int frame[64]{};  // volatile, so that it is not optimised away
  frame[0] = depth;
  return depth < deep_enough ? descend(depth + 1) + frame[0] : 0;
}

}  // namespace

int main() {
  const std::string_view words = articam::hal::semihosting::command_line(storage);
  const articam::Vec<float, 3> v{1, 2, 3};
  if (words.ends_with(" address")) return *reinterpret_cast<volatile int*>(0x30000000);
  if (words.ends_with(" instruction")) asm volatile("udf #0");
  if (words.ends_with(" stack")) return descend(0);
  if (words.ends_with(" assertion")) return static_cast<int>(v[deep_enough]);
  if (words.ends_with(" abort")) std::abort();
  if (words.ends_with(" stop")) articam::hal::stop_with_fault("told to");
  return 0;
}
