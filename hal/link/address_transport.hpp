#pragma once
/// @file  The transport that an address names, chosen when the program starts.

#include "hal/link/serial_transport.hpp"
#include "hal/link/udp_transport.hpp"

namespace articam::hal {

class AddressTransport {
 public:
  /// Errors  those of the transport.
  Status open(const wire::Address& address) noexcept {
    kind_ = address.kind;
    return kind_ == wire::Address::Kind::udp ? udp_.open(address) : serial_.open(address);
  }
  Status send(std::span<const std::uint8_t> packet) noexcept {
    return kind_ == wire::Address::Kind::udp ? udp_.send(packet) : serial_.send(packet);
  }
  std::uint64_t dropped() const noexcept { return udp_.counters().dropped + serial_.counters().dropped; }

 private:
  wire::Address::Kind kind_{wire::Address::Kind::udp};
  UdpTransport udp_;
  SerialTransport serial_;
};

}  // namespace articam::hal
