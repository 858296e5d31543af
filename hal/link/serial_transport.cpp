#include "hal/link/serial_transport.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
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

Status SerialTransport::open(const wire::Address& address) noexcept {
  close();
  const speed_t speed = speed_of(address.baud);
  if (address.kind != wire::Address::Kind::serial || speed == B0) return Status::bad_argument;
  descriptor_ = ::open(address.device.data(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) return Status::no_device;
  if (set_raw(descriptor_, speed)) return Status::ok;
  close();
  return Status::io_error;
}

void SerialTransport::close() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  pending_ = {};
  largest_ = 0;
}

/// Packets that pile up in the system's queue would come out old, and each as if it were the newest.
bool SerialTransport::is_behind() const noexcept {
  int queued = 0;  // bytes; a driver that does not tell has none
  return ::ioctl(descriptor_, TIOCOUTQ, &queued) == 0 && queued > static_cast<int>(largest_);
}

/// True when nothing is left to write.
bool SerialTransport::write_pending() noexcept {
  if (pending_.empty()) return true;
  const ssize_t written = ::write(descriptor_, pending_.data(), pending_.size());
  if (written > 0) pending_ = pending_.subspan(static_cast<std::size_t>(written));
  return pending_.empty();
}

Status SerialTransport::send(std::span<const std::uint8_t> packet) noexcept {
  const std::span<std::uint8_t> frame{frame_};
  if (descriptor_ >= 0 && write_pending() && !is_behind()) {
    const auto size = wire::cobs_encode(packet, frame.subspan(1));
    if (size.ok()) {
      frame[0] = 0;
      pending_ = frame.first(1 + size.value());
      static_cast<void>(write_pending());
      if (pending_.size() <= size.value()) {
        ++counters_.sent;
        largest_ = std::max(largest_, 1 + size.value());
        return Status::ok;
      }
      pending_ = {};  // the line took nothing: full, or gone
    }
  }
  ++counters_.dropped;
  return Status::io_error;
}

}  // namespace articam::hal
