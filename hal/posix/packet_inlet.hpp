#pragma once
/// @file  Where packets come in: a UDP port, a multicast group or a serial line.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/status.hpp"
#include "core/timestamp.hpp"
#include "hal/wire/address.hpp"
#include "hal/wire/cobs.hpp"
#include "hal/wire/packet.hpp"

namespace articam::hal {

/// A packet, sound or not. The kernel stamps a datagram when it comes, however late it is read, on the wall clock; the
/// monotonic time is now less what that clock has counted since. Where it is set forward in between, the packet looks
/// older than it is; set back, no fresher than the reading of it. A serial line has the time of the reading only.
struct Inbound {
  std::span<const std::uint8_t> bytes;  ///< valid until the next call
  Timestamp t_receipt{};                ///< monotonic clock
  std::int64_t t_receipt_wall_ns{};     ///< since 1970
  std::array<std::uint8_t, 4> from{};   ///< address of the sender; 0.0.0.0 on a serial line
};

class PacketInlet {
 public:
  PacketInlet() noexcept = default;
  PacketInlet(const PacketInlet&) = delete;
  PacketInlet& operator=(const PacketInlet&) = delete;
  ~PacketInlet() { close(); }

  /// A group is joined; the address of a host must be one of this machine, or 0.0.0.0 for all of them. `queue_bytes`:
  /// asked of the kernel for the packets that wait; 0 leaves it as the system has it. No heap.
  /// Returns nothing, or why not; errno says more, unless it is 0.
  std::string_view open(const wire::Address& address, int queue_bytes = 0) noexcept;
  void close() noexcept;

  /// Until there is something to read.
  /// Errors  timeout, also when a signal came; io_error. At a timeout a group is joined again, because its interface
  /// may have gone and come back.
  Status wait(int milliseconds) noexcept;

  /// Never waits, and makes one call of the system at most.
  /// Errors  timeout: no whole packet for now; io_error: errno says why. A serial line is then gone for good.
  Status next(Inbound& out) noexcept;

  /// Of a serial line: what stood between two delimiters and was no COBS frame, or too long.
  std::uint64_t broken_frames() const noexcept { return broken_frames_; }

 private:
  Status next_datagram(Inbound& out) noexcept;
  Status next_frame(Inbound& out) noexcept;
  bool take_frame() noexcept;
  bool is_serial() const noexcept { return address_.kind == wire::Address::Kind::serial; }

  int descriptor_{-1};
  wire::Address address_{};
  std::array<std::uint8_t, wire::kMaxPacketSize + 1> buffer_{};  ///< one more, so that an over-long one is seen
  std::size_t next_{}, end_{};                                   ///< what the decoder has not yet taken of it
  wire::CobsDecoder<wire::kMaxPacketSize> decoder_{};
  std::uint64_t broken_frames_{};
};

/// The place that an address names, as written, without options.
std::string place_of(const wire::Address& address);

}  // namespace articam::hal
