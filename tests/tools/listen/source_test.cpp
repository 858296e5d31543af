#include "tools/listen/source.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <string>
#include <vector>

#include "tests/support/udp_ear.hpp"

namespace articam::listen {
namespace {

using std::chrono::milliseconds;

TEST(Address, IsAPortAGroupOrWhatTheLinkTakes) {
  wire::Address address;
  EXPECT_EQ(parse_udp("1234", address), "");
  EXPECT_EQ(address.port, 1234);
  EXPECT_EQ(address.host, (std::array<std::uint8_t, 4>{})) << "every interface";
  EXPECT_EQ(parse_udp("239.1.2.3:5?via=10.0.0.1", address), "");
  EXPECT_TRUE(address.is_multicast());
  EXPECT_EQ(address.via[0], 10);
  EXPECT_EQ(parse_udp("udp://127.0.0.1", address), "");
  EXPECT_EQ(address.port, wire::kDefaultPort);
  EXPECT_EQ(parse_serial("/dev/ttyUSB0?baud=115200", address), "");
  EXPECT_EQ(address.baud, 115200u);
  EXPECT_EQ(parse_serial("serial:///dev/ttyS1", address), "");
  EXPECT_EQ(std::string{address.device.data()}, "/dev/ttyS1");
}

TEST(Address, IsRefusedWithASentenceAndLeftAsItWas) {
  wire::Address address;
  address.port = 9;
  for (const char* text : {"", "0", "70000", "host:1", "239.1.1.1:x", "serial:///dev/ttyS1", "-1"}) {
    EXPECT_NE(parse_udp(text, address), "") << text;
  }
  for (const char* text : {"", "ttyS1", "udp://127.0.0.1", "/dev/ttyS1?speed=1"}) {
    EXPECT_NE(parse_serial(text, address), "") << text;
  }
  EXPECT_EQ(address.port, 9);
}

/// A port that was free a moment ago.
std::uint16_t free_port() { return test::UdpEar{}.port(); }

TEST(Source, HearsDatagramsOfEverySizeAndKnowsItsOwnMachine) {
  wire::Address address;
  address.port = free_port();
  Source source;
  ASSERT_EQ(source.open(address), "");
  EXPECT_FALSE(source.receive(milliseconds{0}).has_value());
  const test::UdpEar mouth;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, wire::kMaxPacketSize, std::size_t{20000}}) {
    ASSERT_TRUE(mouth.say(std::vector<std::uint8_t>(size, 7), address.port));
    const auto received = source.receive(milliseconds{1000});
    ASSERT_TRUE(received.has_value()) << size;
    EXPECT_EQ(received->bytes.size(), std::min(size, wire::kMaxPacketSize + 1)) << "too long is told from just fitting";
    EXPECT_TRUE(received->same_machine);
  }
}

TEST(Source, TellsThatAPortIsTaken) {
  const test::UdpEar ear;
  wire::Address address;
  address.host = {127, 0, 0, 1}, address.port = ear.port();
  Source source;
  const std::string problem = source.open(address);
  EXPECT_NE(problem.find(std::to_string(ear.port())), std::string::npos) << problem;
}

TEST(Source, SharesAGroupWithOtherListeners) {
  wire::Address address;
  ASSERT_EQ(parse_udp("239.255.47.48:" + std::to_string(free_port()) + "?via=127.0.0.1", address), "");
  Source first, second;
  if (!first.open(address).empty()) GTEST_SKIP() << "no multicast here: " << first.problem();
  EXPECT_EQ(second.open(address), "");
}

/// The board's end of a serial line, played by a pseudo terminal.
class SerialSource : public testing::Test {
 protected:
  void SetUp() override {
    board_ = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (board_ < 0 || ::grantpt(board_) != 0 || ::unlockpt(board_) != 0) GTEST_SKIP() << "no pseudo terminal here";
    ASSERT_EQ(parse_serial(::ptsname(board_), address_), "");
    ASSERT_EQ(source_.open(address_), "");
  }
  void TearDown() override {
    if (board_ >= 0) ::close(board_);
  }
  void say(const std::vector<std::uint8_t>& bytes) const {
    EXPECT_EQ(::write(board_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  std::vector<std::uint8_t> hear() {
    for (int i = 0; i < 20; ++i) {
      if (const auto received = source_.receive(milliseconds{100})) {
        return {received->bytes.begin(), received->bytes.end()};
      }
    }
    return {};
  }

  int board_{-1};
  wire::Address address_;
  Source source_;
};

TEST_F(SerialSource, TakesFramesApartThatCameInOnePieceOrInSeveral) {
  const std::vector<std::uint8_t> first{1, 0, 2}, second{3, 3, 0, 0};
  std::array<std::uint8_t, 32> frame{};
  std::vector<std::uint8_t> stream{0};
  for (const auto& packet : {first, second, first}) {
    const auto size = wire::cobs_encode(packet, frame);
    ASSERT_TRUE(size.ok());
    stream.insert(stream.end(), frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size.value()));
  }
  const auto middle = static_cast<std::ptrdiff_t>(stream.size()) - 2;
  say({stream.begin(), stream.begin() + middle});
  EXPECT_EQ(hear(), first);
  EXPECT_EQ(hear(), second);
  say({stream.begin() + middle, stream.end()});
  EXPECT_EQ(hear(), first);
  EXPECT_EQ(source_.broken_frames(), 0u);
}

TEST_F(SerialSource, CountsBrokenFramesAndIsInStepAgainAfterThem) {
  say({9, 1, 0, 3, 1, 2, 0});
  EXPECT_EQ(hear(), (std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(source_.broken_frames(), 1u);
}

TEST_F(SerialSource, TellsThatTheLineIsGone) {
  ::close(std::exchange(board_, -1));
  EXPECT_EQ(hear(), std::vector<std::uint8_t>{});
  EXPECT_NE(source_.problem(), "");
}

TEST(SerialLine, RefusesARateWithoutANameAndAFileThatIsNoLine) {
  wire::Address address;
  ASSERT_EQ(parse_serial("/dev/null", address), "");
  EXPECT_NE(Source{}.open(address), "");
  ASSERT_EQ(parse_serial("/dev/null?baud=12345", address), "");
  EXPECT_NE(Source{}.open(address), "");
}

}  // namespace
}  // namespace articam::listen
