#include "hal/baremetal/semihosting.hpp"

namespace articam::hal::semihosting {
namespace {

enum class Operation : int {
  open = 0x01,
  close = 0x02,
  write0 = 0x04,
  read = 0x06,
  get_command_line = 0x15,
  exit_extended = 0x20,
};

int call(Operation operation, const void* argument) noexcept {
  register int r0 asm("r0") = static_cast<int>(operation);
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

}  // namespace

void write(std::string_view zero_terminated) noexcept { (void)call(Operation::write0, zero_terminated.data()); }

void exit(int code) noexcept {
  constexpr std::uint32_t kApplicationExit = 0x20026;
  const std::uint32_t block[]{kApplicationExit, static_cast<std::uint32_t>(code)};
  (void)call(Operation::exit_extended, block);
  while (true) asm volatile("wfi");  // not reached under a debugger
}

std::string_view command_line(std::span<char> storage) noexcept {
  struct {
    char* text;
    std::size_t size;
  } block{storage.data(), storage.size()};
  if (call(Operation::get_command_line, &block) != 0) return {};
  return {block.text, block.size};
}

File::File(std::string_view zero_terminated_path) noexcept {
  constexpr std::uint32_t kReadBinary = 1;
  const struct {
    const char* path;
    std::uint32_t mode;
    std::size_t length;
  } block{zero_terminated_path.data(), kReadBinary, zero_terminated_path.size()};
  handle_ = call(Operation::open, &block);
}

File::~File() {
  if (is_open()) (void)call(Operation::close, &handle_);
}

std::size_t File::read(std::span<std::uint8_t> out) noexcept {
  const struct {
    int handle;
    std::uint8_t* data;
    std::size_t size;
  } block{handle_, out.data(), out.size()};
  const int left = call(Operation::read, &block);
  return left < 0 || static_cast<std::size_t>(left) > out.size() ? 0 : out.size() - static_cast<std::size_t>(left);
}

}  // namespace articam::hal::semihosting
