#include "hal/wire/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using Bytes = std::vector<std::uint8_t>;

bool protobuf_takes(const Bytes& text) {
  Bytes payload{0x12, static_cast<std::uint8_t>(text.size() + 2), 0x22, static_cast<std::uint8_t>(text.size())};
  payload.insert(payload.end(), text.begin(), text.end());
  return wire::Packet{}.ParseFromArray(payload.data(), static_cast<int>(payload.size()));
}

TEST(Utf8, IsWhatProtobufTakesForItThroughEveryLeadAndEveryPairOfBorders) {
  const google::protobuf::LogSilencer quiet;  // it would print every one that it refuses
  constexpr std::uint8_t kBorders[]{0x00, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf, 0xc0, 0xff};
  for (int lead = 0; lead < 256; ++lead) {
    for (const std::uint8_t second : kBorders) {
      for (const std::uint8_t third : kBorders) {
        for (const std::uint8_t fourth : kBorders) {
          const Bytes all{static_cast<std::uint8_t>(lead), second, third, fourth};
          for (std::size_t size = 1; size <= 4; ++size) {
            const Bytes text(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size));
            ASSERT_EQ(wire::is_utf8(text), protobuf_takes(text)) << testing::PrintToString(text);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace articam
