#pragma once
/// @file  Packets over UDP, to one host or to a multicast group.

#include <netinet/in.h>

#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "hal/wire/address.hpp"

namespace articam::hal {

/// Sends, and never reads: the socket is connected, so that the kernel itself discards what others send to it, and
/// what the peer sends stays in a queue of the least size that the kernel allows.
class UdpTransport {
 public:
  struct Counters {
    std::uint64_t sent{};
    std::uint64_t refused{};  ///< the host answered that nobody listens there; the packet was sent anyway
    std::uint64_t dropped{};  ///< not sent: the queue is full, or there is no way to the host
  };

  UdpTransport() noexcept = default;
  UdpTransport(const UdpTransport&) = delete;
  UdpTransport& operator=(const UdpTransport&) = delete;
  ~UdpTransport() { close(); }

  /// A host that cannot be reached yet, because the network is still coming up, is no error: send() tries again.
  /// Errors  bad_argument when it is no UDP address or the interface `via` is not ours; io_error.
  Status open(const wire::Address& address) noexcept;
  void close() noexcept;

  /// Errors  io_error: dropped. It never waits.
  Status send(std::span<const std::uint8_t> packet) noexcept;

  const Counters& counters() const noexcept { return counters_; }
  int descriptor() const noexcept { return descriptor_; }  ///< of the socket, for tests

 private:
  bool connect() noexcept;

  int descriptor_{-1};
  bool connected_{};
  int failures_{};  ///< in a row
  sockaddr_in peer_{};
  Counters counters_{};
};

}  // namespace articam::hal
