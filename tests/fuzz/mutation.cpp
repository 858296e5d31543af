#include "tests/fuzz/mutation.hpp"

#include <algorithm>

namespace articam::fuzz {
namespace {

using Place = std::ptrdiff_t;

void mutate_once(Bytes& bytes, const Bytes& other, test::Random& random) {
  constexpr std::uint8_t kAwkward[]{0x00, 0x01, 0x7f, 0x80, 0xfe, 0xff};
  if (bytes.empty()) bytes.push_back(0);
  const std::size_t at = below(bytes.size(), random);
  const auto place = bytes.begin() + static_cast<Place>(at);
  const std::size_t piece = 1 + below(std::min<std::size_t>(bytes.size() - at, 16), random);
  switch (below(7, random)) {
    case 0:
      bytes[at] ^= static_cast<std::uint8_t>(1u << below(8, random));
      break;
    case 1:
      bytes[at] = kAwkward[below(std::size(kAwkward), random)];
      break;
    case 2:
      bytes[at] = static_cast<std::uint8_t>(below(256, random));
      break;
    case 3:
      bytes.erase(place, place + static_cast<Place>(piece));
      break;
    case 4: {
      const Bytes copy(place, place + static_cast<Place>(piece));
      bytes.insert(place, copy.begin(), copy.end());
      break;
    }
    case 5:
      if (!other.empty()) {
        const std::size_t from = below(other.size(), random);
        const std::size_t size = 1 + below(std::min<std::size_t>(other.size() - from, 16), random);
        const auto first = other.begin() + static_cast<Place>(from);
        bytes.insert(place, first, first + static_cast<Place>(size));
      }
      break;
    default:
      if (below(4, random) == 0) bytes.resize(at);  // the other changes need something left to change
      break;
  }
}

}  // namespace

std::size_t below(std::size_t n, test::Random& random) {
  return static_cast<std::size_t>(random.uniform(0, static_cast<double>(n)));
}

void mutate(Bytes& bytes, const Bytes& other, test::Random& random) {
  // Mostly few: a message that is nearly right gets farther.
  for (std::size_t n = 1 + below(1 + below(8, random), random); n > 0; --n) mutate_once(bytes, other, random);
}

}  // namespace articam::fuzz
