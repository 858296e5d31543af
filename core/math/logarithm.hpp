#pragma once
/// @file  The natural logarithm, for weighing likelihoods: cheap, and the same bits on every machine.

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace articam::math {

/// ln x, off by 1e-7 or by S's rounding. x is a positive, normal number; of others the result has no meaning.
/// Source  ln m = 2 artanh((m - 1) / (m + 1)), four terms, with x = 2^k m and m between sqrt(1/2) and sqrt(2).
template <class S>
constexpr S log(S x) noexcept {
  using Bits = std::conditional_t<sizeof(S) == 4, std::int32_t, std::int64_t>;
  constexpr int kFraction = std::numeric_limits<S>::digits - 1;
  constexpr Bits kRootHalf = std::bit_cast<Bits>(S(0x1.6a09e667f3bcdp-1));
  const Bits bits = std::bit_cast<Bits>(x);
  const Bits k = (bits - kRootHalf) >> kFraction;  // rounds down: m is not below sqrt(1/2)
  const S m = std::bit_cast<S>(static_cast<Bits>(bits - k * (Bits{1} << kFraction)));
  const S z = (m - S(1)) / (m + S(1)), z2 = z * z;
  const S series = S(1) + z2 * (S(1.0 / 3) + z2 * (S(1.0 / 5) + z2 * S(1.0 / 7)));
  return static_cast<S>(k) * S(0x1.62e42fefa39efp-1) + S(2) * z * series;
}

}  // namespace articam::math
