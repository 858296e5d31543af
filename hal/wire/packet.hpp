#pragma once
/// @file  The packet that goes over UDP as it is, and over a serial line inside a COBS frame.
///
///     offset  size  what
///     0       4     magic, the bytes "ATCM"
///     4       1     version of this format: 1
///     5       1     flags: bit 0, a counter and a tag follow the payload; all others 0
///     6       2     n, size of the payload
///     8       n     payload, one articam.wire.Packet in protobuf's encoding
///     8+n     8     counter, only if flagged
///     16+n    16    tag over all bytes before it, only if flagged
///     end-4   4     CRC-32 over all bytes before it
///
/// Numbers are little-endian.

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "hal/wire/authentication.hpp"
#include "hal/wire/fault.hpp"

namespace articam::wire {

inline constexpr std::size_t kHeaderSize = 8;
inline constexpr std::size_t kTrailerSize = kCounterSize + kTagSize;
inline constexpr std::size_t kChecksumSize = 4;
/// Room for the largest message of articam.proto with the sizes of articam.options.
inline constexpr std::size_t kMaxPayloadSize = 2944;
inline constexpr std::size_t kMaxPacketSize = kHeaderSize + kMaxPayloadSize + kTrailerSize + kChecksumSize;

/// A packet whose frame is sound. Views into the received bytes.
struct PacketView {
  std::span<const std::uint8_t> payload;
  bool has_tag{};
  std::uint64_t counter{};                ///< only if has_tag
  std::span<const std::uint8_t> covered;  ///< what the tag covers; only if has_tag
  std::span<const std::uint8_t> tag;      ///< kTagSize bytes; only if has_tag
};

/// Completes the packet whose payload already stands at kHeaderSize of `buffer`; signs it when there is a signer.
/// The size of the whole packet.
/// Errors  bad_argument when the payload is empty or too large, or the buffer too small; the signer's.
Result<std::size_t> seal_packet(std::span<std::uint8_t> buffer, std::size_t payload_size,
                                Signer* signer = nullptr) noexcept;

/// Checks magic, length, checksum and format; `out` is written only if there is no fault.
Fault open_packet(std::span<const std::uint8_t> bytes, PacketView& out) noexcept;

/// Asks the verifier. Without one every packet passes, tagged or not: authentication is off.
Fault authenticate(const PacketView& packet, Verifier* verifier) noexcept;

}  // namespace articam::wire
