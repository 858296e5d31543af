#pragma once
/// @file  Packets over a serial line, each in a COBS frame.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "hal/wire/address.hpp"
#include "hal/wire/cobs.hpp"
#include "hal/wire/packet.hpp"

namespace articam::hal {

/// Raw, 8 data bits, no parity, one stop bit, no flow control. A zero stands before each frame too, so that noise on a
/// silent line spoils nothing but itself.
///
/// On a line that is too slow the newest packet is dropped while more than one packet still waits in the system's queue
/// (TIOCOUTQ, measured against the largest one sent): what arrives is never older than about two packets take.
class SerialTransport {
 public:
  struct Counters {
    std::uint64_t sent{};     ///< handed to the line whole, or whole but for a tail that follows
    std::uint64_t dropped{};  ///< the line was still busy with packets before, or is gone
  };

  SerialTransport() noexcept = default;
  SerialTransport(const SerialTransport&) = delete;
  SerialTransport& operator=(const SerialTransport&) = delete;
  ~SerialTransport() { close(); }

  /// Errors  bad_argument when it is no serial address or a rate that the system does not name; no_device when the
  /// device cannot be opened; io_error when it is no serial line.
  Status open(const wire::Address& address) noexcept;
  void close() noexcept;

  /// What the line does not take at once is kept and goes before the next packet.
  /// Errors  io_error: dropped, see above. It never waits.
  Status send(std::span<const std::uint8_t> packet) noexcept;

  const Counters& counters() const noexcept { return counters_; }

 private:
  bool write_pending() noexcept;
  bool is_behind() const noexcept;

  int descriptor_{-1};
  std::array<std::uint8_t, 1 + wire::cobs_frame_size(wire::kMaxPacketSize)> frame_{};
  std::span<const std::uint8_t> pending_{};  ///< of frame_, not yet taken by the line
  std::size_t largest_{};                    ///< of the frames sent, bytes
  Counters counters_{};
};

}  // namespace articam::hal
