#include "hal/receiver/udp_inlet.hpp"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include "hal/wire/packet.hpp"

namespace articam::receiver {
namespace {

template <class T>
bool set(int descriptor, int level, int option, const T& value) noexcept {
  return ::setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

/// Empty, or what could not be done.
const char* listen(int descriptor, const wire::Address& address) noexcept {
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = std::bit_cast<in_addr_t>(address.host);  // of a group too: then no other packets arrive
  own.sin_port = htons(address.port);
  // Several programs of one machine may listen to the same group.
  if (address.is_multicast() && !set(descriptor, SOL_SOCKET, SO_REUSEADDR, 1)) return "cannot share the port";
  if (::bind(descriptor, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0) return "cannot be listened to";
  const ip_mreq group{.imr_multiaddr = own.sin_addr, .imr_interface = {std::bit_cast<in_addr_t>(address.via)}};
  if (address.is_multicast() && !set(descriptor, IPPROTO_IP, IP_ADD_MEMBERSHIP, group)) return "cannot be joined";
  return "";
}

std::string text_of(const wire::Address& address) {
  std::string text = "udp://";
  for (const std::uint8_t byte : address.host) text += std::to_string(byte) + '.';
  text.back() = ':';
  return text + std::to_string(address.port);
}

}  // namespace

Status UdpInlet::open(const wire::Address& address, std::string& problem) {
  close();
  if (address.kind != wire::Address::Kind::udp) {
    problem = "the receiver hears UDP only: give it an address such as udp://239.1.1.1:47047";
    return Status::bad_argument;
  }
  descriptor_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const char* const failed = descriptor_ < 0 ? "cannot be opened" : listen(descriptor_, address);
  if (*failed == '\0') return Status::ok;
  problem = text_of(address) + ' ' + failed + ": " + std::strerror(errno);
  close();
  return Status::io_error;
}

void UdpInlet::close() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

Status UdpInlet::wait(int milliseconds) const noexcept {
  pollfd ready{.fd = descriptor_, .events = POLLIN, .revents = 0};
  const int count = ::poll(&ready, 1, milliseconds);
  if (count == 0 || (count < 0 && errno == EINTR)) return Status::timeout;
  return count > 0 && (ready.revents & POLLNVAL) == 0 ? Status::ok : Status::io_error;
}

std::span<const std::uint8_t> UdpInlet::next() noexcept {
  static_assert(sizeof packet_ > wire::kMaxPacketSize);
  const ssize_t size = ::recv(descriptor_, packet_.data(), packet_.size(), 0);
  if (size < 0) return {};
  return {packet_.data(), static_cast<std::size_t>(size)};
}

Timestamp UdpInlet::now() noexcept {
  timespec t{};
  ::clock_gettime(CLOCK_MONOTONIC, &t);  // cannot fail for this clock
  return {static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec};
}

}  // namespace articam::receiver
