#include "hal/posix/packet_inlet.hpp"

#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include "hal/posix/monotonic_clock.hpp"
#include "hal/posix/serial_line.hpp"

namespace articam::hal {
namespace {

std::int64_t in_ns(const timespec& t) noexcept { return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec; }

template <class T>
bool set(int descriptor, int level, int option, const T& value) noexcept {
  return ::setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

/// Also again: then it fails where we still belong to the group, and does no harm.
bool join(int descriptor, const wire::Address& group) noexcept {
  const ip_mreq request{.imr_multiaddr = {std::bit_cast<in_addr_t>(group.host)},
                        .imr_interface = {std::bit_cast<in_addr_t>(group.via)}};
  return set(descriptor, IPPROTO_IP, IP_ADD_MEMBERSHIP, request);
}

/// Empty, or what could not be done.
std::string_view listen(int descriptor, const wire::Address& address, int queue_bytes) noexcept {
  constexpr int kOn = 1;
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = std::bit_cast<in_addr_t>(address.host);  // of a group too: then no other packets arrive
  own.sin_port = htons(address.port);
  set(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, kOn);  // an emulator may not know it
  if (queue_bytes > 0) set(descriptor, SOL_SOCKET, SO_RCVBUF, queue_bytes);
  // Several programs may listen to a group, never to a port: the kernel would give each packet to one of them only.
  if (address.is_multicast() && !set(descriptor, SOL_SOCKET, SO_REUSEADDR, kOn)) return "cannot share the port";
  if (::bind(descriptor, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0) return "cannot be listened to";
  if (address.is_multicast() && !join(descriptor, address)) {
    return "cannot be joined; with ?via=ADDRESS you choose the interface";
  }
  return {};
}

/// How long it has waited in the socket, ns, by the kernel's stamp; 0 without one.
std::int64_t waited_ns(msghdr& message, std::int64_t wall_ns) noexcept {
  timespec stamp{};
  const cmsghdr* const control = CMSG_FIRSTHDR(&message);
  if (control == nullptr || control->cmsg_level != SOL_SOCKET || control->cmsg_type != SCM_TIMESTAMPNS ||
      control->cmsg_len != CMSG_LEN(sizeof stamp)) {
    return 0;
  }
  std::memcpy(&stamp, CMSG_DATA(control), sizeof stamp);
  return std::max<std::int64_t>(wall_ns - in_ns(stamp), 0);
}

/// The monotonic clock first: a thread that is interrupted between the two makes a packet older, never fresher.
void put_time(Inbound& out) noexcept {
  timespec wall{};
  out.t_receipt = MonotonicClock{}.now();
  ::clock_gettime(CLOCK_REALTIME, &wall);  // cannot fail for this clock
  out.t_receipt_wall_ns = in_ns(wall);
}

Status why_nothing() noexcept { return errno == EAGAIN || errno == EINTR ? Status::timeout : Status::io_error; }

}  // namespace

std::string_view PacketInlet::open(const wire::Address& address, int queue_bytes) noexcept {
  close();
  errno = 0;
  address_ = address;
  if (is_serial()) {
    const auto line = open_serial_line(address, O_RDONLY);
    if (line.ok()) descriptor_ = line.value();
    if (line.status() == Status::bad_argument) return "has no such rate: take one such as 115200 or 921600";
    return line.ok() ? "" : line.status() == Status::no_device ? "cannot be opened" : "is no serial line";
  }
  descriptor_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (descriptor_ < 0) return "cannot be opened";
  const std::string_view failed = listen(descriptor_, address, queue_bytes);
  const int error = errno;
  if (!failed.empty()) close();
  errno = error;
  return failed;
}

void PacketInlet::close() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  next_ = end_ = 0;
  decoder_ = {};
}

Status PacketInlet::wait(int milliseconds) noexcept {
  if (next_ < end_) return Status::ok;
  pollfd ready{.fd = descriptor_, .events = POLLIN, .revents = 0};
  const int count = ::poll(&ready, 1, milliseconds);
  if (count < 0) return why_nothing();
  // An interface that goes takes the membership with it, without a word, and does not bring it back.
  if (count == 0 && address_.is_multicast()) join(descriptor_, address_);
  return count > 0 ? Status::ok : Status::timeout;
}

Status PacketInlet::next(Inbound& out) noexcept { return is_serial() ? next_frame(out) : next_datagram(out); }

Status PacketInlet::next_datagram(Inbound& out) noexcept {
  sockaddr_in from{};
  alignas(cmsghdr) std::array<std::uint8_t, CMSG_SPACE(sizeof(timespec))> control{};
  iovec room{buffer_.data(), buffer_.size()};
  msghdr message{};
  message.msg_name = &from, message.msg_namelen = sizeof from;
  message.msg_iov = &room, message.msg_iovlen = 1;
  message.msg_control = control.data(), message.msg_controllen = control.size();
  const ssize_t size = ::recvmsg(descriptor_, &message, 0);
  if (size < 0) return why_nothing();
  put_time(out);
  const std::int64_t waited = waited_ns(message, out.t_receipt_wall_ns);
  out.t_receipt.ns -= waited;
  out.t_receipt_wall_ns -= waited;
  out.bytes = std::span{buffer_}.first(static_cast<std::size_t>(size));
  out.from = std::bit_cast<std::array<std::uint8_t, 4>>(from.sin_addr.s_addr);
  return Status::ok;
}

Status PacketInlet::next_frame(Inbound& out) noexcept {
  if (!take_frame()) {
    const ssize_t size = ::read(descriptor_, buffer_.data(), buffer_.size());
    if (size < 0) return why_nothing();
    if (size == 0) {  // hung up
      errno = EIO;
      return Status::io_error;
    }
    next_ = 0, end_ = static_cast<std::size_t>(size);
    if (!take_frame()) return Status::timeout;
  }
  put_time(out);
  out.bytes = decoder_.frame();
  out.from = {};
  return Status::ok;
}

bool PacketInlet::take_frame() noexcept {
  using Event = decltype(decoder_)::Event;
  while (next_ < end_) {
    const Event event = decoder_.take(buffer_[next_++]);
    if (event == Event::broken) ++broken_frames_;
    if (event == Event::frame) return true;
  }
  return false;
}

std::string place_of(const wire::Address& address) {
  if (address.kind == wire::Address::Kind::serial) return std::string{"serial://"} + address.device.data();
  std::string text = "udp://";
  for (const std::uint8_t byte : address.host) text += std::to_string(byte) + '.';
  text.back() = ':';
  return text + std::to_string(address.port);
}

}  // namespace articam::hal
