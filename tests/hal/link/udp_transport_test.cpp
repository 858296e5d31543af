#include "hal/link/udp_transport.hpp"

#include <gtest/gtest.h>
#include <sys/ioctl.h>

#include <string>

#include "hal/link/address_transport.hpp"
#include "hal/link/packet_link.hpp"
#include "tests/support/heap_trap.hpp"
#include "tests/support/udp_ear.hpp"

namespace articam {
namespace {

using Bytes = std::vector<std::uint8_t>;
static_assert(hal::Transport<hal::UdpTransport>);

wire::Address address(const std::string& text) {
  wire::Address out;
  EXPECT_EQ(wire::parse_address(text, out), "");
  return out;
}
wire::Address local(std::uint16_t port) { return address("udp://127.0.0.1:" + std::to_string(port)); }

/// Bytes that wait to be read; a lower bound where the kernel tells only of the first packet.
int waiting(const hal::UdpTransport& transport) {
  int bytes = 0;
  EXPECT_EQ(::ioctl(transport.descriptor(), FIONREAD, &bytes), 0);
  return bytes;
}

TEST(UdpTransport, APacketArrivesAsItIs) {
  const test::UdpEar ear;
  hal::UdpTransport transport;
  ASSERT_EQ(transport.open(local(ear.port())), Status::ok);
  const Bytes packet{1, 0, 2};
  ASSERT_EQ(transport.send(packet), Status::ok);
  EXPECT_EQ(ear.hear(), packet);
  EXPECT_EQ(transport.counters().sent, 1u);
}

TEST(UdpTransport, WithoutAListenerEveryPacketIsStillSentAndTheRefusalsAreCounted) {
  std::uint16_t port = 0;
  {
    const test::UdpEar gone;
    port = gone.port();
  }
  hal::UdpTransport transport;
  ASSERT_EQ(transport.open(local(port)), Status::ok);
  for (int k = 0; k < 100; ++k) ASSERT_EQ(transport.send(Bytes(600, 1)), Status::ok) << k;
  EXPECT_EQ(transport.counters().sent, 100u);
  EXPECT_GT(transport.counters().refused, 0u);
  EXPECT_EQ(transport.counters().dropped, 0u);
}

TEST(UdpTransport, AListenerThatComesLateIsHeard) {
  std::uint16_t port = 0;
  hal::UdpTransport transport;
  {
    const test::UdpEar early;
    port = early.port();
    ASSERT_EQ(transport.open(local(port)), Status::ok);
  }
  (void)transport.send(Bytes{1});
  (void)transport.send(Bytes{2});
  const int late = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in own{};
  own.sin_family = AF_INET, own.sin_addr.s_addr = htonl(INADDR_LOOPBACK), own.sin_port = htons(port);
  ASSERT_EQ(::bind(late, reinterpret_cast<const sockaddr*>(&own), sizeof own), 0);
  ASSERT_EQ(transport.send(Bytes{3}), Status::ok);
  std::uint8_t heard = 0;
  EXPECT_EQ(::recv(late, &heard, 1, MSG_DONTWAIT), 1);
  EXPECT_EQ(heard, 3);
  ::close(late);
}

TEST(UdpTransport, ForeignPacketsNeverReachTheSocketAndThePeersAreNeverRead) {
  const test::UdpEar peer, stranger;
  hal::UdpTransport transport;
  ASSERT_EQ(transport.open(local(peer.port())), Status::ok);
  const std::uint16_t own_port = test::UdpEar::port_of(transport.descriptor());
  for (int k = 0; k < 1000; ++k) (void)stranger.say(Bytes(100, 1), own_port);
  EXPECT_EQ(waiting(transport), 0);
  for (int k = 0; k < 1000; ++k) (void)peer.say(Bytes(100, 1), own_port);
  const int queued = waiting(transport);
  EXPECT_GT(queued, 0) << "the peer's packets do arrive";
  for (int k = 0; k < 100; ++k) ASSERT_EQ(transport.send(Bytes{1}), Status::ok);
  EXPECT_EQ(waiting(transport), queued) << "sending reads nothing";
}

TEST(UdpTransport, ReachesAMulticastGroupOnLoopback) {
  const int listener = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in any{};
  any.sin_family = AF_INET;
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&any), sizeof any), 0);
  ip_mreq group{};
  group.imr_multiaddr.s_addr = ::inet_addr("239.255.47.47"), group.imr_interface.s_addr = htonl(INADDR_LOOPBACK);
  const bool joined = ::setsockopt(listener, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) == 0;
  const in_addr loopback{htonl(INADDR_LOOPBACK)};
  if (!joined || ::setsockopt(listener, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback) != 0) {
    ::close(listener);
    GTEST_SKIP() << "this machine, or its emulator, has no multicast on loopback";
  }
  hal::UdpTransport transport;
  const std::string port = std::to_string(test::UdpEar::port_of(listener));
  ASSERT_EQ(transport.open(address("udp://239.255.47.47:" + port + "?via=127.0.0.1")), Status::ok);
  ASSERT_EQ(transport.send(Bytes{7}), Status::ok);
  pollfd ready{listener, POLLIN, 0};
  EXPECT_EQ(::poll(&ready, 1, 1000), 1);
  int ttl = 0;
  socklen_t size = sizeof ttl;
  EXPECT_EQ(::getsockopt(transport.descriptor(), IPPROTO_IP, IP_MULTICAST_TTL, &ttl, &size), 0);
  EXPECT_EQ(ttl, 1);
  ::close(listener);
}

TEST(UdpTransport, AHostThatCannotBeReachedYetIsTriedAgainAtEveryPacket) {
  hal::UdpTransport transport;
  wire::Address broadcast = local(9);
  broadcast.host = {255, 255, 255, 255};  // the parser refuses it; the kernel does not connect to it: like no network
  ASSERT_EQ(transport.open(broadcast), Status::ok);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(transport.send(Bytes{1}), Status::io_error);
  EXPECT_EQ(transport.counters().dropped, 100u);
}

TEST(UdpTransport, APacketThatIsTooLargeIsDroppedAndTheNextOneGoes) {
  const test::UdpEar ear;
  hal::UdpTransport transport;
  ASSERT_EQ(transport.open(local(ear.port())), Status::ok);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(transport.send(Bytes(70000, 1)), Status::io_error);
  EXPECT_EQ(transport.send(Bytes{1}), Status::ok);
  EXPECT_EQ(ear.hear(), Bytes{1});
}

TEST(UdpTransport, RefusesASerialAddressAndAnInterfaceThatIsNotOurs) {
  hal::UdpTransport transport;
  EXPECT_EQ(transport.open(address("serial:///dev/null")), Status::bad_argument);
  EXPECT_EQ(transport.open(address("udp://239.1.1.1?via=192.0.2.1")), Status::bad_argument);
  EXPECT_EQ(transport.send(Bytes{1}), Status::io_error);
}

TEST(AddressTransport, IsTheTransportThatTheAddressNames) {
  static_assert(hal::Transport<hal::AddressTransport>);
  const test::UdpEar ear;
  hal::AddressTransport transport;
  ASSERT_EQ(transport.open(local(ear.port())), Status::ok);
  ASSERT_EQ(transport.send(Bytes{5}), Status::ok);
  EXPECT_EQ(ear.hear(), Bytes{5});
  EXPECT_EQ(transport.open(address("serial:///dev/no_such_line")), Status::no_device);
  EXPECT_EQ(transport.send(Bytes{5}), Status::io_error);
  EXPECT_EQ(transport.dropped(), 1u);
}

TEST(UdpTransport, SendingDoesNotTouchTheHeap) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  const test::UdpEar ear;
  hal::UdpTransport transport;
  ASSERT_EQ(transport.open(local(ear.port())), Status::ok);
  const Bytes packet(600, 1);
  const test::HeapTrap trap;
  for (int k = 0; k < 100; ++k) (void)transport.send(packet);
  EXPECT_EQ(trap.calls(), 0);
}

}  // namespace
}  // namespace articam
