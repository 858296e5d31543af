#pragma once
/// @file  What a debugger or an emulator does for a program without an operating system: text, files, the end.
///
/// Source  ARM, "Semihosting for AArch32 and AArch64", release 2.0. Without a debugger the calls fault: a product
///         replaces these functions by its own UART and reset.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace articam::hal::semihosting {

/// Onto the console. The text must end with a zero behind its last character, as literals and Line do.
void write(std::string_view zero_terminated) noexcept;

/// Ends the program; the emulator's process returns the code.
[[noreturn]] void exit(int code) noexcept;

/// The words that the program was started with, its own name first; empty when they do not fit.
std::string_view command_line(std::span<char> storage) noexcept;

/// A file of the machine that emulates or debugs, opened for reading.
class File {
 public:
  /// The path must end with a zero behind its last character.
  explicit File(std::string_view zero_terminated_path) noexcept;
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool is_open() const noexcept { return handle_ >= 0; }
  /// The number of bytes read, fewer than asked for at the end of the file.
  std::size_t read(std::span<std::uint8_t> out) noexcept;

 private:
  int handle_{-1};
};

}  // namespace articam::hal::semihosting
