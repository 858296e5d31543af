#pragma once
/// @file  Messages as bytes, by nanopb.

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "hal/wire/message.hpp"

namespace articam::hal {

/// One articam.wire.Packet in protobuf's encoding, and its size. No heap; about 3 kB of stack.
/// Errors  bad_argument when `out` is too small.
Result<std::size_t> encode_message(const wire::EstimateMessage& estimate, std::span<std::uint8_t> out) noexcept;
Result<std::size_t> encode_message(const wire::ModelMessage& model, std::span<std::uint8_t> out) noexcept;

}  // namespace articam::hal
