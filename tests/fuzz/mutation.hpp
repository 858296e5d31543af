#pragma once
/// @file  Small damage to bytes, the same for the same seed on every machine.

#include <cstdint>
#include <vector>

#include "tests/support/random_state.hpp"

namespace articam::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// A whole number from 0 to n - 1.
std::size_t below(std::size_t n, test::Random& random);

/// One to eight changes: bits flipped, bytes set to values that decoders trip over, pieces removed, repeated, put in
/// from `other`, cut off.
void mutate(Bytes& bytes, const Bytes& other, test::Random& random);

}  // namespace articam::fuzz
