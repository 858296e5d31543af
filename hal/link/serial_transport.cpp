#include "hal/link/serial_transport.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "hal/posix/serial_line.hpp"

namespace articam::hal {
Status SerialTransport::open(const wire::Address& address) noexcept {
  close();
  const auto line = open_serial_line(address, O_RDWR);
  if (line.ok()) descriptor_ = line.value();
  return line.status();
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
