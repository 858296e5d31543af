#include "tools/listen/source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tests/support/pseudo_terminal.hpp"
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
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, wire::kMaxPacketSize}) {
    ASSERT_TRUE(mouth.say(std::vector<std::uint8_t>(size, 7), address.port));
    const auto received = source.receive(milliseconds{1000});
    ASSERT_TRUE(received.has_value()) << size;
    EXPECT_EQ(received->bytes.size(), size);
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

TEST(Source, HearsASerialLineUntilItIsGone) {
  test::PseudoTerminal board;
  if (!board.works()) GTEST_SKIP() << "no pseudo terminal here";
  wire::Address address;
  ASSERT_EQ(parse_serial(board.path(), address), "");
  Source source;
  ASSERT_EQ(source.open(address), "");
  const std::vector<std::uint8_t> packet{1, 0, 2};
  ASSERT_TRUE(board.say(test::framed(packet)));
  const auto received = source.receive(milliseconds{1000});
  ASSERT_TRUE(received.has_value());
  EXPECT_TRUE(std::ranges::equal(received->bytes, packet));
  EXPECT_FALSE(received->same_machine) << "nobody knows who is at the other end";
  EXPECT_EQ(source.problem(), "");
  board.hang_up();
  EXPECT_FALSE(source.receive(milliseconds{1000}).has_value());
  EXPECT_NE(source.problem().find(address.device.data()), std::string::npos) << source.problem();
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
