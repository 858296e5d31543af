#include "hal/wire/crc32.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string_view>
#include <vector>

namespace articam {
namespace {

constexpr std::uint32_t crc32_of(std::string_view text) {
  std::array<std::uint8_t, 64> bytes{};
  for (std::size_t i = 0; i < text.size(); ++i) bytes[i] = static_cast<std::uint8_t>(text[i]);
  return wire::crc32(std::span{bytes}.first(text.size()));
}

// The check value of the catalogue of parametrised CRC algorithms, and two that zlib gives.
static_assert(crc32_of("123456789") == 0xcbf43926u);
static_assert(crc32_of("") == 0);
static_assert(crc32_of("The quick brown fox jumps over the lazy dog") == 0x414fa339u);

/// CRC-32 is linear: whether an error is seen depends on the error alone, so these pairs stand for all packets of that
/// length.
TEST(Crc32, SeesEveryOneAndEveryTwoFlippedBits) {
  std::vector<std::uint8_t> packet(200);
  std::iota(packet.begin(), packet.end(), std::uint8_t{1});
  const std::uint32_t right = wire::crc32(packet);
  const auto flip = [&](std::size_t bit) { packet[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8); };
  int seen = 0;
  for (std::size_t a = 0; a < 8 * packet.size(); ++a) {
    flip(a);
    seen += wire::crc32(packet) != right ? 1 : 0;
    flip(a);
    const std::size_t b = (a * 7919 + 13) % (8 * packet.size());
    flip(a), flip(b);
    seen += wire::crc32(packet) != right || a == b ? 1 : 0;
    flip(a), flip(b);
  }
  EXPECT_EQ(seen, 2 * 1600);
}

}  // namespace
}  // namespace articam
