#include "hal/link/udp_transport.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <utility>

namespace articam::hal {
namespace {

/// A route may come back through another interface: then the socket needs another source address.
constexpr int kFailuresToReconnect = 30;

template <class T>
bool set(int descriptor, int level, int option, const T& value) noexcept {
  return ::setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

bool set_up(int descriptor, const wire::Address& address) noexcept {
  constexpr int kLeast = 0;  // the kernel raises it to what it allows
  if (!set(descriptor, SOL_SOCKET, SO_RCVBUF, kLeast)) return false;
  if (!address.is_multicast()) return true;
  const in_addr via{std::bit_cast<in_addr_t>(address.via)};
  return set(descriptor, IPPROTO_IP, IP_MULTICAST_TTL, int{address.ttl}) &&
         (via.s_addr == 0 || set(descriptor, IPPROTO_IP, IP_MULTICAST_IF, via));
}

}  // namespace

Status UdpTransport::open(const wire::Address& address) noexcept {
  close();
  if (address.kind != wire::Address::Kind::udp) return Status::bad_argument;
  descriptor_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (descriptor_ < 0) return Status::io_error;
  if (!set_up(descriptor_, address)) {
    close();
    return Status::bad_argument;
  }
  peer_.sin_family = AF_INET;
  peer_.sin_addr.s_addr = std::bit_cast<in_addr_t>(address.host);
  peer_.sin_port = htons(address.port);
  static_cast<void>(connect());
  return Status::ok;
}

void UdpTransport::close() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  connected_ = false;
  failures_ = 0;
}

bool UdpTransport::connect() noexcept {
  const sockaddr nobody{.sa_family = AF_UNSPEC, .sa_data = {}};
  ::connect(descriptor_, &nobody, sizeof nobody);  // lets go of the old source address
  connected_ = ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&peer_), sizeof peer_) == 0;
  return connected_;
}

Status UdpTransport::send(std::span<const std::uint8_t> packet) noexcept {
  // The answer to an earlier packet, that nobody listens, is told in place of sending this one: so it is sent again.
  constexpr int kAttempts = 2;
  if (failures_ == kFailuresToReconnect) connected_ = false, failures_ = 0;
  const bool ready = descriptor_ >= 0 && (connected_ || connect());
  for (int i = 0; ready && i < kAttempts; ++i) {
    if (::send(descriptor_, packet.data(), packet.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(packet.size())) {
      ++counters_.sent;
      failures_ = 0;
      return Status::ok;
    }
    if (errno != ECONNREFUSED) break;
    ++counters_.refused;
  }
  ++counters_.dropped;
  ++failures_;
  return Status::io_error;
}

}  // namespace articam::hal
