#pragma once
/// @file  A plain socket on loopback that hears what a transport sends.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <vector>

namespace articam::test {

/// Bound to 127.0.0.1 and a free port.
class UdpEar {
 public:
  UdpEar() {
    const sockaddr_in any = loopback(0);
    (void)::bind(socket_, reinterpret_cast<const sockaddr*>(&any), sizeof any);
  }
  UdpEar(const UdpEar&) = delete;
  UdpEar& operator=(const UdpEar&) = delete;
  ~UdpEar() { ::close(socket_); }

  std::uint16_t port() const { return port_of(socket_); }

  /// The next packet; empty when none comes within a second.
  std::vector<std::uint8_t> hear() const {
    pollfd ready{socket_, POLLIN, 0};
    std::vector<std::uint8_t> packet(65536);
    const ssize_t size = ::poll(&ready, 1, 1000) == 1 ? ::recv(socket_, packet.data(), packet.size(), 0) : 0;
    packet.resize(static_cast<std::size_t>(size > 0 ? size : 0));
    return packet;
  }

  bool say(const std::vector<std::uint8_t>& packet, std::uint16_t port) const {
    const sockaddr_in to = loopback(port);
    return ::sendto(socket_, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to) ==
           static_cast<ssize_t>(packet.size());
  }

  static std::uint16_t port_of(int socket) {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    ::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &size);
    return ntohs(own.sin_port);
  }

 private:
  static sockaddr_in loopback(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
  }

  int socket_{::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
};

}  // namespace articam::test
