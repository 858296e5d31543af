#pragma once
/// @file  The socket of a receiver.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/status.hpp"
#include "hal/receiver/intake.hpp"
#include "hal/wire/address.hpp"

namespace articam::receiver {

class UdpInlet {
 public:
  /// Packets read at one wake-up, at most: under a flood too, the thread soon looks up again.
  static constexpr int kMostAtOnce = 64;

  UdpInlet() noexcept = default;
  UdpInlet(const UdpInlet&) = delete;
  UdpInlet& operator=(const UdpInlet&) = delete;
  ~UdpInlet() { close(); }

  /// A group is joined; the address of a host must be one of this machine: both ends are given the same address.
  /// Errors  bad_argument, io_error; `problem` is then a sentence.
  Status open(const wire::Address& address, std::string& problem);
  void close() noexcept;

  /// Errors  timeout; io_error.
  Status wait(int milliseconds) const noexcept;

  /// Hands up to kMostAtOnce packets to the intake and calls `taken(what, t_receipt)` after each that counts; never
  /// waits. The number of packets read.
  template <class Taken>
  int read(Intake& intake, Taken taken) noexcept {
    int count = 0;
    for (; count < kMostAtOnce; ++count) {
      const std::span<const std::uint8_t> packet = next();
      if (packet.data() == nullptr) break;
      const Timestamp t_receipt = now();
      if (const auto what = intake.take(packet, t_receipt); what != Intake::Taken::nothing) taken(what, t_receipt);
    }
    return count;
  }

  /// CLOCK_MONOTONIC of this machine.
  static Timestamp now() noexcept;

 private:
  std::span<const std::uint8_t> next() noexcept;

  int descriptor_{-1};
  std::array<std::uint8_t, 4096> packet_{};  // larger than any of ours: what is longer is not mistaken for one
};

}  // namespace articam::receiver
