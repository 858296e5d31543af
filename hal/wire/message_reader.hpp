#pragma once
/// @file  Reads the payload of a packet. Needs no protobuf library.

#include <cstdint>
#include <span>

#include "hal/wire/fault.hpp"
#include "hal/wire/message.hpp"

namespace articam::wire {

/// One articam.wire.Packet in protobuf's encoding. Reads nothing beyond the span, whatever it holds, in one pass.
/// Unknown fields are skipped, so that newer boards may add some. What protobuf would only tolerate (a known field of
/// another wire type, a number too large for its field, two contents, groups) is refused, and so are names that are not
/// UTF-8.
/// Errors  malformed; unknown_schema. `out` is then half written.
/// Source  protobuf.dev/programming-guides/encoding
Fault parse_message(std::span<const std::uint8_t> payload, Message& out) noexcept;

/// inconsistent unless every number is finite, the lists of a valid estimate fit together and those of one that is not
/// valid are empty, quaternions are of unit length, variances are not negative and the estimate is not sent before it
/// was seen.
Fault check(const EstimateMessage& estimate) noexcept;
/// inconsistent unless every number is finite, a pose is one, and each name says something: without control characters,
/// commas and quotes, since names reach terminals and the heads of CSV files.
Fault check(const ModelMessage& model) noexcept;

/// Both: what this passes may be used without another look.
Fault read_message(std::span<const std::uint8_t> payload, Message& out) noexcept;

}  // namespace articam::wire
