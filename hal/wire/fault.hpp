#pragma once
/// @file  Why received bytes are not a packet that may be used.

#include <cstdint>
#include <string_view>

namespace articam::wire {

enum class [[nodiscard]] Fault : std::uint8_t{
    none,
    foreign,         ///< does not begin like a packet of ours
    wrong_length,    ///< cut short, or longer than it says itself
    wrong_checksum,  ///< changed on the way
    unknown_format,  ///< made by another version of the packet format
    not_authentic,   ///< the tag is wrong, or there is none where one is asked for
    replayed,        ///< the tag is right, but its counter has been seen or passed
    malformed,       ///< the payload is not a message of articam.proto
    unknown_schema,  ///< a message of another schema
    inconsistent,    ///< numbers that are not finite, or lists whose lengths contradict each other
    wrong_model,     ///< the board runs another model than the receiver was told
};
inline constexpr int kNumFaults = 11;  ///< `none` included

/// The name of a fault, as written in logs.
std::string_view name(Fault fault) noexcept;

}  // namespace articam::wire
