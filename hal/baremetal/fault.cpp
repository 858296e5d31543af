#include "hal/baremetal/fault.hpp"

#include <cstddef>
#include <cstdint>

#include "hal/baremetal/line.hpp"
#include "hal/baremetal/semihosting.hpp"

extern "C" {
extern std::uint32_t articam_stack_bottom, articam_stack_top;  // from the linker script
[[noreturn, gnu::used]] void articam_report_fault(std::uint32_t exception, const std::uint32_t* stack);
}

namespace articam::hal {

void stop_with_fault(const char* why) noexcept {
  Line line;
  semihosting::write((line << "fault: " << why << '\n').text());
  semihosting::exit(kFaultExitCode);
}

}  // namespace articam::hal

extern "C" {

/// The stack may be the culprit, so the report gets its own.
[[gnu::naked]] void articam_fault() {
  asm volatile(
      "mrs r0, ipsr\n"
      "mrs r1, msp\n"
      "ldr r2, =articam_fault_stack_top\n"
      "msr msp, r2\n"
      "b articam_report_fault\n");
}

/// Source  ARMv7-M Architecture Reference Manual, B3.2.15 (CFSR), B1.5.6 (the frame that the processor stacks).
void articam_report_fault(std::uint32_t exception, const std::uint32_t* stack) {
  using namespace articam::hal;
  constexpr std::size_t kStackedPc = 6, kStackedWords = 8;
  const bool overflow = stack < &articam_stack_bottom;
  Line line;
  line << "fault: " << (overflow ? "the stack has overflowed, " : "") << "exception " << exception << ", status "
       << hex(*reinterpret_cast<const volatile std::uint32_t*>(0xE000ED28U));
  if (!overflow && stack + kStackedWords <= &articam_stack_top) line << ", at " << hex(stack[kStackedPc]);
  semihosting::write((line << '\n').text());
  semihosting::exit(kFaultExitCode);
}

/// What a failed assert or eigen_assert calls (builds without NDEBUG).
[[noreturn]] void __assert_func(const char* file, int line_number, const char*, const char* condition) {
  using namespace articam::hal;
  Line line;
  line << "fault: " << file << ':' << line_number << ": not true: " << condition << '\n';
  semihosting::write(line.text());
  semihosting::exit(kFaultExitCode);
}

[[noreturn]] void abort() { articam::hal::stop_with_fault("abort was called"); }
}
