#include "tools/listen/serial_line.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <map>

namespace articam::listen {
namespace {

const std::map<std::uint32_t, speed_t> kSpeeds{
    {9600, B9600},       {19200, B19200},     {38400, B38400},     {57600, B57600},     {115200, B115200},
    {230400, B230400},   {460800, B460800},   {500000, B500000},   {921600, B921600},   {1000000, B1000000},
    {1500000, B1500000}, {2000000, B2000000}, {3000000, B3000000}, {4000000, B4000000},
};

bool set_raw(int descriptor, speed_t speed) {
  termios line{};
  if (::tcgetattr(descriptor, &line) != 0) return false;
  ::cfmakeraw(&line);  // 8 bits, no parity, nothing translated
  line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  line.c_cflag |= CLOCAL | CREAD;
  return ::cfsetspeed(&line, speed) == 0 && ::tcsetattr(descriptor, TCSANOW, &line) == 0;
}

}  // namespace

int open_serial_line(const char* device, std::uint32_t baud) {
  const auto speed = kSpeeds.find(baud);
  if (speed == kSpeeds.end()) {
    errno = EINVAL;
    return -1;
  }
  const int descriptor = ::open(device, O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0 || set_raw(descriptor, speed->second)) return descriptor;
  const int error = errno;
  ::close(descriptor);
  errno = error;
  return -1;
}

}  // namespace articam::listen
