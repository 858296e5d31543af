#pragma once
/// @file  Where packets come from: a UDP port or a serial line.

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/timestamp.hpp"
#include "hal/posix/packet_inlet.hpp"
#include "hal/wire/address.hpp"

namespace articam::listen {

/// Reads `47047` (every interface), `[GROUP:]PORT` or an address as the board's link takes it. The host part of one
/// that is no group is an address of this machine. Empty, or a sentence that says what to write instead.
std::string parse_udp(std::string_view text, wire::Address& out);
/// Reads `/dev/ttyUSB0`, `/dev/ttyUSB0?baud=115200` or `serial:///dev/...`.
std::string parse_serial(std::string_view text, wire::Address& out);

struct Received {
  std::span<const std::uint8_t> bytes;  ///< of one packet, sound or not; valid until the next call
  Timestamp at;                         ///< receipt by this machine, see hal::Inbound; monotonic clock
  std::int64_t at_wall_ns{};            ///< the same since 1970
  bool same_machine{};                  ///< sent from here, so that `at` is on the sender's clock
};

class Source {
 public:
  /// Empty, or why nothing can be received there.
  std::string open(const wire::Address& address);
  /// The next packet, or nothing within `wait` or when a signal came.
  std::optional<Received> receive(std::chrono::milliseconds wait);

  std::uint64_t broken_frames() const { return inlet_.broken_frames(); }
  const std::string& problem() const { return problem_; }  ///< not empty when nothing will come any more

 private:
  std::string fail(std::string_view what);
  bool is_own(const std::array<std::uint8_t, 4>& host);

  hal::PacketInlet inlet_;
  bool is_serial_{};
  std::string place_, problem_;
  std::array<std::uint8_t, 4> last_host_{};  ///< the last sender, and whether it is this machine
  bool last_is_own_{};
};

}  // namespace articam::listen
