#pragma once
/// @file  Where packets come from: a UDP port or a serial line.

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/timestamp.hpp"
#include "hal/wire/address.hpp"
#include "hal/wire/cobs.hpp"
#include "hal/wire/packet.hpp"

namespace articam::listen {

/// Reads `47047` (every interface), `[GROUP:]PORT` or an address as the board's link takes it. The host part of one
/// that is no group is an address of this machine. Empty, or a sentence that says what to write instead.
std::string parse_udp(std::string_view text, wire::Address& out);
/// Reads `/dev/ttyUSB0`, `/dev/ttyUSB0?baud=115200` or `serial:///dev/...`.
std::string parse_serial(std::string_view text, wire::Address& out);

struct Received {
  std::span<const std::uint8_t> bytes;  ///< of one packet, sound or not; valid until the next call
  Timestamp at;                         ///< monotonic clock
  std::int64_t at_wall_ns{};            ///< since 1970
  bool same_machine{};                  ///< sent from here, so that `at` is on the sender's clock
};

class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  ~Source();

  /// Empty, or why nothing can be received there.
  std::string open(const wire::Address& address);
  /// The next packet, or nothing within `wait` or when a signal came.
  std::optional<Received> receive(std::chrono::milliseconds wait);

  std::uint64_t broken_frames() const { return broken_frames_; }  ///< on the serial line: no COBS frame, or too long
  const std::string& problem() const { return problem_; }         ///< not empty when nothing will come any more

 private:
  std::string open_udp(const wire::Address& address);
  std::string open_serial(const wire::Address& address);
  std::string fail(const std::string& what);
  bool is_own(std::uint32_t host);
  std::optional<Received> receive_datagram();
  std::optional<Received> next_frame();
  Received stamped(std::span<const std::uint8_t> bytes, bool same_machine) const;

  int descriptor_{-1};
  bool is_serial_{};
  std::string name_, problem_;
  std::uint32_t last_host_{};  ///< the last sender, and whether it is this machine
  bool last_is_own_{};
  std::uint64_t broken_frames_{};
  std::array<std::uint8_t, wire::kMaxPacketSize + 1> buffer_{};  ///< one more, so that an over-long one is seen
  std::size_t next_{}, end_{};                                   ///< what the decoder has not yet taken of it
  wire::CobsDecoder<wire::kMaxPacketSize> decoder_;
};

}  // namespace articam::listen
