#include "hal/posix/serial_line.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <utility>

namespace articam::hal {
namespace {

/// The system's name of a rate; B0, which hangs up, when it has none.
speed_t speed_of(std::uint32_t baud) noexcept {
  constexpr std::pair<std::uint32_t, speed_t> kSpeeds[]{
      {9600, B9600},       {19200, B19200},     {38400, B38400},     {57600, B57600},     {115200, B115200},
      {230400, B230400},   {460800, B460800},   {500000, B500000},   {921600, B921600},   {1000000, B1000000},
      {1500000, B1500000}, {2000000, B2000000}, {3000000, B3000000}, {4000000, B4000000},
  };
  for (const auto& [rate, speed] : kSpeeds) {
    if (rate == baud) return speed;
  }
  return B0;
}

bool set_raw(int descriptor, speed_t speed) noexcept {
  termios line{};
  if (::tcgetattr(descriptor, &line) != 0) return false;
  ::cfmakeraw(&line);  // 8 bits, no parity, nothing translated
  line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  line.c_cflag |= CLOCAL | CREAD;
  return ::cfsetspeed(&line, speed) == 0 && ::tcsetattr(descriptor, TCSANOW, &line) == 0;
}

}  // namespace

Result<int> open_serial_line(const wire::Address& address, int access) noexcept {
  const speed_t speed = speed_of(address.baud);
  if (address.kind != wire::Address::Kind::serial || speed == B0) return Status::bad_argument;
  const int descriptor = ::open(address.device.data(), access | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return Status::no_device;
  if (set_raw(descriptor, speed)) return descriptor;
  const int error = errno;
  ::close(descriptor);
  errno = error;
  return Status::io_error;
}

}  // namespace articam::hal
