#include "hal/wire/address.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

using wire::Address;
using Ip = std::array<std::uint8_t, 4>;

Address parsed(std::string_view text) {
  Address address;
  EXPECT_EQ(wire::parse_address(text, address), "") << text;
  return address;
}

TEST(Address, OfOneHostHasThePortThatIsWrittenOrTheUsualOne) {
  const Address address = parsed("udp://10.0.0.2:5000");
  EXPECT_EQ(address.kind, Address::Kind::udp);
  EXPECT_EQ(address.host, (Ip{10, 0, 0, 2}));
  EXPECT_EQ(address.port, 5000);
  EXPECT_FALSE(address.is_multicast());
  EXPECT_EQ(parsed("udp://10.0.0.2").port, 47047);
}

TEST(Address, OfAGroupStaysInTheLocalNetworkUnlessToldOtherwise) {
  EXPECT_TRUE(parsed("udp://239.1.1.1").is_multicast());
  EXPECT_EQ(parsed("udp://239.1.1.1").ttl, 1);
  const Address address = parsed("udp://239.1.1.1:47047?ttl=4&via=192.168.0.7");
  EXPECT_EQ(address.ttl, 4);
  EXPECT_EQ(address.via, (Ip{192, 168, 0, 7}));
}

TEST(Address, OfASerialLineHasItsPathAndRate) {
  const Address address = parsed("serial:///dev/ttyS1?baud=115200");
  EXPECT_EQ(address.kind, Address::Kind::serial);
  EXPECT_STREQ(address.device.data(), "/dev/ttyS1");
  EXPECT_EQ(address.baud, 115200u);
  EXPECT_EQ(parsed("serial:///dev/ttyAMA0").baud, 921600u);
}

TEST(Address, WhatIsNoAddressIsRefusedWithASentenceAndChangesNothing) {
  for (const std::string_view text :
       {"",
        "10.0.0.2",
        "udp:/10.0.0.2",
        "tcp://10.0.0.2",
        "udp://",
        "udp://localhost",
        "udp://10.0.0",
        "udp://10.0.0.2.3",
        "udp://10.0.0.256",
        "udp://10.0.0.2:",
        "udp://10.0.0.2:0",
        "udp://10.0.0.2:65536",
        "udp://10.0.0.2:x",
        "udp://1.2.3.4:5:6",
        "udp://0.0.0.0",
        "udp://255.255.255.255",
        "udp://10.0.0.2?ttl=2",
        "udp://239.1.1.1?ttl=0",
        "udp://239.1.1.1?ttl=256",
        "udp://239.1.1.1?via=eth0",
        "udp://239.1.1.1?speed=9",
        "udp://-1.0.0.1",
        "udp://1.+2.3.4",
        "udp://99999999999.1.1.1",
        "serial://ttyS1",
        "serial://",
        "serial:///dev/ttyS1?baud=fast",
        "serial:///dev/ttyS1?baud=0",
        "serial:///dev/ttyS1?ttl=1",
        "serial:///a/path/that/is/far/longer/than/any/device/of/a/board/would/ever/need"}) {
    Address address;
    address.port = 1;
    EXPECT_GT(wire::parse_address(text, address).size(), 10u) << text;
    EXPECT_EQ(address.port, 1) << text;
  }
}

}  // namespace
}  // namespace articam
