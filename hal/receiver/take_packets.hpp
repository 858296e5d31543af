#pragma once
/// @file  From the inlet to the intake, in bounded pieces.

#include "hal/posix/packet_inlet.hpp"
#include "hal/receiver/intake.hpp"

namespace articam::receiver {

/// Packets read at one wake-up, at most: under a flood too, the thread soon looks up again.
inline constexpr int kMostAtOnce = 64;

/// Hands what has come to the intake, and calls `taken(what, t_receipt)` after each packet that counts; never waits.
/// Errors  timeout: all has been read; io_error: the inlet has failed.
template <class Taken>
Status take_packets(hal::PacketInlet& inlet, Intake& intake, Taken taken) noexcept {
  hal::Inbound packet;
  for (int count = 0; count < kMostAtOnce; ++count) {
    if (const Status status = inlet.next(packet); status != Status::ok) return status;
    const auto what = intake.take(packet.bytes, packet.t_receipt);
    if (what != Intake::Taken::nothing) taken(what, packet.t_receipt);
  }
  return Status::ok;
}

}  // namespace articam::receiver
