#include "hal/wire/cobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/support/random_state.hpp"

namespace articam {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Decoder = wire::CobsDecoder<600>;

Bytes encoded(const Bytes& bytes) {
  Bytes frame(wire::cobs_frame_size(bytes.size()));
  const auto size = wire::cobs_encode(bytes, frame);
  EXPECT_TRUE(size.ok());
  frame.resize(size.value());
  return frame;
}

/// Every frame that a stream gives, and how many were broken.
struct Heard {
  std::vector<Bytes> frames;
  int broken{};
};
Heard hear(Decoder& decoder, const Bytes& stream) {
  Heard heard;
  for (const std::uint8_t byte : stream) {
    const auto event = decoder.take(byte);
    if (event == Decoder::Event::frame) heard.frames.emplace_back(decoder.frame().begin(), decoder.frame().end());
    heard.broken += event == Decoder::Event::broken ? 1 : 0;
  }
  return heard;
}

/// Few different bytes, so that zeros and long runs without one both come up.
Bytes random_bytes(test::Random& random, std::size_t largest) {
  Bytes bytes(static_cast<std::size_t>(random.uniform(0, static_cast<double>(largest) + 1)));
  const double zeros = random.uniform(0, 1) < 0.5 ? 0.0 : 0.2;
  for (auto& byte : bytes) byte = random.uniform(0, 1) < zeros ? 0 : static_cast<std::uint8_t>(random.uniform(1, 256));
  return bytes;
}

TEST(Cobs, GivesTheFramesOfThePaper) {
  EXPECT_EQ(encoded({}), (Bytes{1, 0}));
  EXPECT_EQ(encoded({0}), (Bytes{1, 1, 0}));
  EXPECT_EQ(encoded({0, 0}), (Bytes{1, 1, 1, 0}));
  EXPECT_EQ(encoded({0x11, 0x22, 0, 0x33}), (Bytes{3, 0x11, 0x22, 2, 0x33, 0}));
  EXPECT_EQ(encoded({0x11, 0, 0, 0}), (Bytes{2, 0x11, 1, 1, 1, 0}));
}

TEST(Cobs, BlocksOf254BytesWithoutAZeroNeedOneMoreByte) {
  const Bytes bytes(254, 7);
  const Bytes frame = encoded(bytes);
  EXPECT_EQ(frame.size(), 256u);
  EXPECT_EQ(frame.front(), 0xff);
  Bytes longer = bytes;
  longer.push_back(7);
  EXPECT_EQ(encoded(longer).size(), 258u);
}

TEST(Cobs, ARoundTripGivesTheBytesBackAndNoFrameHasAZeroInside) {
  test::Random random{1};
  for (int trial = 0; trial < 3000; ++trial) {
    const Bytes bytes = random_bytes(random, 600);
    const Bytes frame = encoded(bytes);
    ASSERT_LE(frame.size(), wire::cobs_frame_size(bytes.size()));
    ASSERT_EQ(std::ranges::count(frame, 0), 1);
    Decoder decoder;
    const Heard heard = hear(decoder, frame);
    ASSERT_EQ(heard.frames.size(), 1u) << "seed 1, trial " << trial;
    ASSERT_EQ(heard.frames[0], bytes);
  }
}

TEST(Cobs, ABufferThatIsTooSmallIsRefused) {
  Bytes frame(wire::cobs_frame_size(300) - 1);
  EXPECT_EQ(wire::cobs_encode(Bytes(300, 1), frame).status(), Status::bad_argument);
}

TEST(CobsDecoder, IsInStepAgainAtTheNextDelimiterAfterAnyNoise) {
  test::Random random{2};
  for (int trial = 0; trial < 2000; ++trial) {
    const Bytes noise = random_bytes(random, 900), bytes = random_bytes(random, 300), frame = encoded(bytes);
    Decoder decoder;
    (void)hear(decoder, noise);
    (void)hear(decoder, {0});
    const Heard heard = hear(decoder, frame);
    ASSERT_EQ(heard.frames.size(), 1u) << "seed 2, trial " << trial;
    ASSERT_EQ(heard.frames[0], bytes);
    ASSERT_EQ(heard.broken, 0);
  }
}

TEST(CobsDecoder, CountsATornFrameOnce) {
  Decoder decoder;
  Bytes torn = encoded({1, 2, 3, 4});
  torn.erase(torn.begin() + 2);
  EXPECT_EQ(hear(decoder, torn).broken, 1);
  EXPECT_EQ(hear(decoder, {0, 0, 0}).broken, 0);
}

TEST(CobsDecoder, RefusesAFrameLargerThanItsRoomAndTakesOneThatJustFits) {
  Decoder decoder;
  EXPECT_EQ(hear(decoder, encoded(Bytes(600, 5))).frames.size(), 1u);
  EXPECT_EQ(hear(decoder, encoded(Bytes(601, 5))).broken, 1);
  EXPECT_EQ(hear(decoder, encoded(Bytes(601, 0))).broken, 1);
  EXPECT_EQ(hear(decoder, encoded(Bytes(600, 0))).frames.size(), 1u);
}

}  // namespace
}  // namespace articam
