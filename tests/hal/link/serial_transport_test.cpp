#include "hal/link/serial_transport.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

#include <cstdarg>
#include <string>
#include <vector>

#include "hal/link/packet_link.hpp"
#include "tests/support/random_state.hpp"

namespace {
int bytes_in_queue = -1;  ///< what TIOCOUTQ answers; -1: the system's word. A pseudo terminal always says 0.
}

/// Stands before the system's.
extern "C" int ioctl(int descriptor, unsigned long request, ...) noexcept {
  std::va_list rest;
  va_start(rest, request);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  if (request == TIOCOUTQ && bytes_in_queue >= 0) return *static_cast<int*>(argument) = bytes_in_queue, 0;
  return static_cast<int>(::syscall(SYS_ioctl, descriptor, request, argument));
}

namespace articam {
namespace {

using Bytes = std::vector<std::uint8_t>;
static_assert(hal::Transport<hal::SerialTransport>);

/// The far end of a serial line, played by a pseudo terminal.
class SerialTransport : public testing::Test {
 protected:
  void SetUp() override {
    far_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (far_ < 0 || ::grantpt(far_) != 0 || ::unlockpt(far_) != 0) GTEST_SKIP() << "no pseudo terminal here";
    ASSERT_EQ(wire::parse_address("serial://" + std::string(::ptsname(far_)) + "?baud=115200", address_), "");
  }
  void TearDown() override {
    if (far_ >= 0) ::close(far_);
  }

  /// What the line has by now.
  Bytes drain() const {
    Bytes all, part(4096);
    pollfd ready{far_, POLLIN, 0};
    while (::poll(&ready, 1, 50) == 1) {
      const ssize_t n = ::read(far_, part.data(), part.size());
      if (n <= 0) break;
      all.insert(all.end(), part.begin(), part.begin() + n);
    }
    return all;
  }
  std::vector<Bytes> frames(const Bytes& stream) {
    std::vector<Bytes> all;
    for (const std::uint8_t byte : stream) {
      const auto event = decoder_.take(byte);
      if (event == Decoder::Event::frame) all.emplace_back(decoder_.frame().begin(), decoder_.frame().end());
      broken_ += event == Decoder::Event::broken ? 1 : 0;
    }
    return all;
  }

  using Decoder = wire::CobsDecoder<wire::kMaxPacketSize>;
  int far_{-1};
  wire::Address address_{};
  Decoder decoder_{};
  int broken_{};
};

Bytes random_packet(test::Random& random, std::size_t size) {
  Bytes packet(size);
  for (auto& byte : packet) byte = static_cast<std::uint8_t>(random.uniform(0, 256));
  return packet;
}

TEST_F(SerialTransport, EveryByteValuePassesUnchanged) {
  hal::SerialTransport transport;
  ASSERT_EQ(transport.open(address_), Status::ok);
  Bytes packet(256);
  for (std::size_t i = 0; i < 256; ++i) packet[i] = static_cast<std::uint8_t>(i);
  ASSERT_EQ(transport.send(packet), Status::ok);
  EXPECT_EQ(frames(drain()), std::vector<Bytes>{packet});
  EXPECT_EQ(broken_, 0);
}

TEST_F(SerialTransport, NoiseOnTheSilentLineSpoilsNoPacket) {
  hal::SerialTransport transport;
  ASSERT_EQ(transport.open(address_), Status::ok);
  ASSERT_EQ(transport.send(Bytes{1, 2, 3}), Status::ok);
  Bytes stream = drain();
  const Bytes noise{9, 8, 7};
  stream.insert(stream.begin(), noise.begin(), noise.end());
  EXPECT_EQ(frames(stream), (std::vector<Bytes>{{1, 2, 3}}));
}

TEST_F(SerialTransport, AFullLineDropsWholePacketsAndTearsNone) {
  hal::SerialTransport transport;
  ASSERT_EQ(transport.open(address_), Status::ok);
  test::Random random{31};
  std::vector<Bytes> accepted;
  int dropped = 0;
  Bytes heard;
  for (int k = 0; k < 400; ++k) {
    const Bytes packet = random_packet(random, 700);
    if (transport.send(packet) == Status::ok) {
      accepted.push_back(packet);
    } else {
      ++dropped;
    }
    if (k % 50 == 49) {
      const Bytes part = drain();
      heard.insert(heard.end(), part.begin(), part.end());
    }
  }
  const auto flush = transport.send(Bytes{1});  // brings the last tail with it
  accepted.insert(accepted.end(), flush == Status::ok ? 1 : 0, Bytes{1});
  const Bytes part = drain();
  heard.insert(heard.end(), part.begin(), part.end());
  EXPECT_GT(dropped, 0) << "the line was never full";
  EXPECT_EQ(transport.counters().dropped, static_cast<std::uint64_t>(dropped));
  EXPECT_EQ(frames(heard), accepted) << "seed 31";
  EXPECT_EQ(broken_, 0);
}

TEST_F(SerialTransport, DropsTheNewestWhileMoreThanOnePacketWaitsInTheSystemsQueue) {
  hal::SerialTransport transport;
  ASSERT_EQ(transport.open(address_), Status::ok);
  const Bytes packet(100, 1);
  const int frame = static_cast<int>(1 + wire::cobs_frame_size(packet.size()));
  const auto send_behind = [&](int bytes) {
    bytes_in_queue = bytes;
    const Status status = transport.send(packet);
    bytes_in_queue = -1;
    return status;
  };
  EXPECT_EQ(send_behind(0), Status::ok);
  EXPECT_EQ(send_behind(frame), Status::ok);
  EXPECT_EQ(send_behind(frame + 1), Status::io_error);
  EXPECT_EQ(send_behind(frame), Status::ok);
  EXPECT_EQ(transport.counters().dropped, 1u);
  EXPECT_EQ(frames(drain()).size(), 3u);
}

TEST_F(SerialTransport, ALineThatIsGoneIsAnErrorAtEveryPacketAndNothingWorse) {
  hal::SerialTransport transport;
  ASSERT_EQ(transport.open(address_), Status::ok);
  ::close(std::exchange(far_, -1));
  for (int k = 0; k < 10; ++k) EXPECT_EQ(transport.send(Bytes{1}), Status::io_error);
}

TEST_F(SerialTransport, TheLineIsRawAtTheRateOfTheAddress) {
  hal::SerialTransport transport;
  ASSERT_EQ(transport.open(address_), Status::ok);
  termios line{};
  ASSERT_EQ(::tcgetattr(far_, &line), 0);
  EXPECT_EQ(::cfgetospeed(&line), static_cast<speed_t>(B115200));
  EXPECT_EQ(line.c_lflag & static_cast<tcflag_t>(ECHO | ICANON | ISIG), 0u);
  EXPECT_EQ(line.c_oflag & static_cast<tcflag_t>(OPOST), 0u);
  EXPECT_EQ(line.c_cflag & static_cast<tcflag_t>(CSIZE), static_cast<tcflag_t>(CS8));
}

TEST(SerialAddress, IsRefusedWhereItIsNoSerialLine) {
  hal::SerialTransport transport;
  const auto open = [&](const char* text) {
    wire::Address address;
    EXPECT_EQ(wire::parse_address(text, address), "");
    return transport.open(address);
  };
  EXPECT_EQ(open("udp://127.0.0.1"), Status::bad_argument);
  EXPECT_EQ(open("serial:///dev/null?baud=12345"), Status::bad_argument);
  EXPECT_EQ(open("serial:///dev/null"), Status::io_error);
  EXPECT_EQ(open("serial:///dev/no_such_line"), Status::no_device);
}

}  // namespace
}  // namespace articam
