#pragma once
/// @file  Messages as protobuf's encoding allows them and as no board writes them.

#include "tests/fuzz/mutation.hpp"

namespace articam::fuzz {

/// A payload of one content, mostly, whose fields come in any order, twice, packed or one by one, with numbers that are
/// padded or too large, of wrong types or unknown. What is damaged is the meaning; the encoding itself is mostly sound,
/// so that decoders get far.
Bytes odd_message(test::Random& random);

}  // namespace articam::fuzz
