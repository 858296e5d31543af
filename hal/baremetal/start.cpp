/// @file  From reset to main: vector table, memory, floating-point unit, constructors.

#include <cstdint>

#include "hal/baremetal/fault.hpp"
#include "hal/baremetal/semihosting.hpp"

extern "C" {
int articam_main() asm("main");  // C++ does not let a program call its main by name
using Constructor = void (*)();
// Placed by the linker script; only their addresses mean something.
extern std::uint32_t articam_stack_top;
extern std::uint32_t articam_data_image, articam_data_begin, articam_data_end;
extern std::uint32_t articam_bss_begin, articam_bss_end;
extern const Constructor articam_constructors_begin, articam_constructors_end;
[[noreturn]] void articam_start();
}

namespace {

/// Everything up to the constructors. Must not use the floating-point unit before it is on.
void prepare_memory() {
#if defined(__ARM_FP)
  // CPACR: full access to coprocessors 10 and 11. Source  ARMv7-M Architecture Reference Manual, B3.2.20.
  *reinterpret_cast<volatile std::uint32_t*>(0xE000ED88U) |= 0xFU << 20;
  asm volatile("dsb\n isb" ::: "memory");
#endif
  const std::uint32_t* from = &articam_data_image;
  for (std::uint32_t* to = &articam_data_begin; to != &articam_data_end;) *to++ = *from++;
  for (volatile std::uint32_t* to = &articam_bss_begin; to != &articam_bss_end;) *to++ = 0;
}

using Handler = void (*)();
struct Vectors {
  std::uint32_t* stack_top;
  Handler handlers[15];  ///< exceptions 1 (reset) to 15 (SysTick)
};

}  // namespace

extern "C" {

[[noreturn]] void articam_start() {
  prepare_memory();
  for (const Constructor* construct = &articam_constructors_begin; construct != &articam_constructors_end;) {
    (*construct++)();
  }
  articam::hal::semihosting::exit(articam_main());
}

/// A board with interrupts appends theirs. Source  ARMv7-M Architecture Reference Manual, B1.5.2.
[[gnu::section(".vectors"), gnu::used]] extern const Vectors articam_vectors{
    &articam_stack_top,
    {articam_start, articam_fault, articam_fault, articam_fault, articam_fault, articam_fault, articam_fault,
     articam_fault, articam_fault, articam_fault, articam_fault, articam_fault, articam_fault, articam_fault,
     articam_fault}};
}
