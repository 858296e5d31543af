#include "hal/wire/packet.hpp"

#include <gtest/gtest.h>

#include "hal/wire/crc32.hpp"

#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using test::Bytes;
using wire::Fault;

/// Counts up, and signs with a sum: enough to see what is covered and where it stands.
class PlainSigner final : public wire::Signer {
 public:
  Result<std::uint64_t> next_counter() noexcept override {
    if (empty) return Status::io_error;
    return ++counter;
  }
  void sign(std::span<const std::uint8_t> covered, wire::Tag tag) noexcept override {
    for (std::size_t i = 0; i < tag.size(); ++i) tag[i] = static_cast<std::uint8_t>(covered.size() + i);
  }
  std::uint64_t counter{};
  bool empty{};
};

class RefusingVerifier final : public wire::Verifier {
 public:
  Fault admit(std::span<const std::uint8_t>, std::uint64_t, wire::ConstTag) noexcept override {
    ++asked;
    return Fault::not_authentic;
  }
  int asked{};
};

Bytes packet(wire::Signer* signer = nullptr) {
  test::Random random{3};
  return test::packet_of(test::random_estimate(random), signer);
}
Fault open(const Bytes& bytes) {
  wire::PacketView view;
  return wire::open_packet(bytes, view);
}

TEST(Packet, GivesItsPayloadBack) {
  const std::string payload = "any bytes will do";
  const Bytes bytes = test::sealed(payload);
  wire::PacketView view;
  ASSERT_EQ(wire::open_packet(bytes, view), Fault::none);
  EXPECT_EQ(std::string(view.payload.begin(), view.payload.end()), payload);
  EXPECT_FALSE(view.has_tag);
  EXPECT_EQ(bytes.size(), payload.size() + 12);
}

TEST(Packet, CarriesCounterAndTagOfItsSigner) {
  PlainSigner signer;
  signer.counter = 0x0102030405060707;
  const Bytes bytes = packet(&signer);
  wire::PacketView view;
  ASSERT_EQ(wire::open_packet(bytes, view), Fault::none);
  ASSERT_TRUE(view.has_tag);
  EXPECT_EQ(view.counter, 0x0102030405060708u);
  EXPECT_EQ(view.covered.size(), wire::kHeaderSize + view.payload.size() + wire::kCounterSize);
  EXPECT_EQ(view.tag[0], static_cast<std::uint8_t>(view.covered.size()));
  EXPECT_EQ(view.tag.size(), wire::kTagSize);
}

TEST(Packet, IsNotSealedWithoutACounter) {
  PlainSigner signer;
  signer.empty = true;
  Bytes buffer(wire::kMaxPacketSize);
  EXPECT_EQ(wire::seal_packet(buffer, 10, &signer).status(), Status::io_error);
}

TEST(Packet, IsNotSealedEmptyTooLargeOrIntoASmallBuffer) {
  Bytes buffer(wire::kMaxPacketSize + 1);
  EXPECT_EQ(wire::seal_packet(buffer, 0).status(), Status::bad_argument);
  EXPECT_EQ(wire::seal_packet(buffer, wire::kMaxPayloadSize + 1).status(), Status::bad_argument);
  EXPECT_TRUE(wire::seal_packet(buffer, wire::kMaxPayloadSize).ok());
  EXPECT_EQ(wire::seal_packet(std::span{buffer}.first(111), 100).status(), Status::bad_argument);
  EXPECT_TRUE(wire::seal_packet(std::span{buffer}.first(112), 100).ok());
}

TEST(Packet, EverySingleFlippedBitIsAFault) {
  PlainSigner signer;
  for (Bytes bytes : {packet(), packet(&signer)}) {
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
      const Fault fault = open(bytes);
      ASSERT_EQ(fault, bit < 32 ? Fault::foreign : Fault::wrong_checksum) << "bit " << bit;
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    }
    EXPECT_EQ(open(bytes), Fault::none);
  }
}

TEST(Packet, EveryTruncatedOneIsAFault) {
  const Bytes bytes = packet();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    // An exact copy: the address sanitizer sees a read beyond its end.
    ASSERT_NE(open(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))), Fault::none) << size;
  }
  Bytes longer = bytes;
  longer.push_back(0);
  EXPECT_NE(open(longer), Fault::none);
}

/// What a sender of bad will can do: any header, with the checksum made right again.
TEST(Packet, WrongHeadersWithARightChecksumAreNamed) {
  const auto resealed = [](std::size_t place, std::uint8_t value) {
    Bytes bytes = packet();
    bytes[place] = value;
    const std::uint32_t crc = wire::crc32(std::span{bytes}.first(bytes.size() - 4));
    for (std::size_t i = 0; i < 4; ++i) bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
    return open(bytes);
  };
  EXPECT_EQ(resealed(4, 2), Fault::unknown_format);
  EXPECT_EQ(resealed(5, 2), Fault::unknown_format);
  EXPECT_EQ(resealed(5, 1), Fault::wrong_length) << "a tag is flagged, and there is no room for it";
  EXPECT_EQ(resealed(7, 0xff), Fault::wrong_length);
  EXPECT_EQ(resealed(6, 0), Fault::wrong_length);
  EXPECT_EQ(resealed(4, 1), Fault::none);
}

TEST(Packet, AVerifierIsAskedForEveryTagAndRefusesWhatHasNone) {
  PlainSigner signer;
  RefusingVerifier verifier;
  const Bytes plain = packet(), tagged = packet(&signer);
  wire::PacketView view;
  ASSERT_EQ(wire::open_packet(plain, view), Fault::none);
  EXPECT_EQ(wire::authenticate(view, nullptr), Fault::none);
  EXPECT_EQ(wire::authenticate(view, &verifier), Fault::not_authentic);
  EXPECT_EQ(verifier.asked, 0);
  ASSERT_EQ(wire::open_packet(tagged, view), Fault::none);
  EXPECT_EQ(wire::authenticate(view, &verifier), Fault::not_authentic);
  EXPECT_EQ(verifier.asked, 1);
}

TEST(Fault, EachHasItsOwnName) {
  for (int i = 0; i < wire::kNumFaults; ++i) {
    for (int k = 0; k < i; ++k) EXPECT_NE(wire::name(static_cast<Fault>(i)), wire::name(static_cast<Fault>(k)));
  }
}

}  // namespace
}  // namespace articam
