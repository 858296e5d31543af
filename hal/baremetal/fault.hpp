#pragma once
/// @file  The end of a program that cannot go on: a message on the console and a non-zero exit code, never a hang.

namespace articam::hal {

inline constexpr int kFaultExitCode = 3;

/// Says why on the console and ends the program.
[[noreturn]] void stop_with_fault(const char* why) noexcept;

}  // namespace articam::hal

/// Handler of every exception that this firmware does not expect: hard, memory, bus and usage faults, a stack that has
/// overflowed, interrupts that nobody switched on.
extern "C" void articam_fault();
