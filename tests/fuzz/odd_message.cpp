#include "tests/fuzz/odd_message.hpp"

#include <bit>
#include <limits>

namespace articam::fuzz {
namespace {

template <class T, std::size_t N>
T any_of(const T (&choices)[N], test::Random& random) {
  return choices[below(N, random)];
}

/// Seldom longer than it must be, by up to nine bytes.
void put_varint(Bytes& bytes, std::uint64_t x, test::Random& random) {
  for (; x > 0x7f; x >>= 7) bytes.push_back(static_cast<std::uint8_t>(x | 0x80));
  bytes.push_back(static_cast<std::uint8_t>(x));
  if (below(20, random) != 0) return;
  for (std::size_t n = 1 + below(9, random); n > 0; --n) {
    bytes.back() |= 0x80;
    bytes.push_back(0);
  }
}

void put_number(Bytes& bytes, std::size_t size, test::Random& random) {
  constexpr double kNumbers[]{0, 1, -1, 0.5, 1e300, -0.0, std::numeric_limits<double>::infinity()};
  const auto bits = std::bit_cast<std::uint64_t>(any_of(kNumbers, random));
  for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> 8 * i));
}

Bytes any_bytes(test::Random& random) {
  Bytes bytes;
  const std::size_t kind = below(4, random);
  const std::size_t size = below(kind == 0 ? 70 : 9, random);
  for (std::size_t i = 0; i < size; ++i) {
    if (kind == 0) bytes.push_back('a');
    if (kind == 1) put_number(bytes, 8, random);
    if (kind == 2) put_varint(bytes, below(4, random), random);
    if (kind == 3) bytes.push_back(static_cast<std::uint8_t>(0x60 + below(160, random)));
  }
  return bytes;
}

void put_bytes(Bytes& out, std::uint64_t tag, const Bytes& bytes, test::Random& random) {
  put_varint(out, tag << 3 | 2, random);
  put_varint(out, bytes.size(), random);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void put_field(Bytes& out, test::Random& random) {
  constexpr std::uint64_t kValues[]{0, 0, 1, 1, 1, 2, 2, 5, 6, 13, 14, 127, 0xffffffff, 0x100000000, ~std::uint64_t{0}};
  constexpr std::uint64_t kTypes[]{0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2, 3, 5};
  const std::uint64_t number = 1 + below(20, random), type = any_of(kTypes, random);
  if (type == 2) return put_bytes(out, number, any_bytes(random), random);
  put_varint(out, number << 3 | type, random);
  if (type == 0) put_varint(out, any_of(kValues, random), random);
  if (type == 1 || type == 5) put_number(out, type == 1 ? 8 : 4, random);
}

}  // namespace

Bytes odd_message(test::Random& random) {
  const std::uint64_t content = 1 + below(2, random);
  Bytes body{0x08, 0x01}, payload;                                  // the schema
  if (content == 2) put_bytes(body, 4, any_bytes(random), random);  // a model has a name
  for (std::size_t n = below(6, random); n > 0; --n) put_field(body, random);
  put_bytes(payload, content, body, random);
  for (std::size_t n = below(8, random); n > 6; --n) put_field(payload, random);
  return payload;
}

}  // namespace articam::fuzz
