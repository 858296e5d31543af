#include "hal/posix/serial_line.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <termios.h>
#include <unistd.h>

#include <string>

#include "tests/support/pseudo_terminal.hpp"

namespace articam {
namespace {

Result<int> open(const std::string& text) {
  wire::Address address;
  EXPECT_EQ(wire::parse_address(text, address), "");
  return hal::open_serial_line(address, O_RDONLY);
}

TEST(SerialLine, IsRawAtTheRateOfTheAddressAndDoesNotBlock) {
  const test::PseudoTerminal far;
  if (!far.works()) GTEST_SKIP() << "no pseudo terminal here";
  const auto line = open("serial://" + far.path() + "?baud=115200");
  ASSERT_TRUE(line.ok());
  termios mode{};
  ASSERT_EQ(::tcgetattr(line.value(), &mode), 0);
  EXPECT_EQ(::cfgetispeed(&mode), static_cast<speed_t>(B115200));
  EXPECT_EQ(mode.c_lflag & static_cast<tcflag_t>(ECHO | ICANON | ISIG), 0u);
  EXPECT_EQ(mode.c_iflag & static_cast<tcflag_t>(ICRNL | IXON | ISTRIP), 0u);
  EXPECT_EQ(mode.c_cflag & static_cast<tcflag_t>(CSIZE | CSTOPB | PARENB), static_cast<tcflag_t>(CS8));
  char byte = 0;
  EXPECT_EQ(::read(line.value(), &byte, 1), -1);
  EXPECT_EQ(errno, EAGAIN);
  ::close(line.value());
}

TEST(SerialLine, IsRefusedWhereItIsNone) {
  EXPECT_EQ(open("udp://127.0.0.1").status(), Status::bad_argument);
  EXPECT_EQ(open("serial:///dev/null?baud=12345").status(), Status::bad_argument) << "a rate without a name";
  EXPECT_EQ(open("serial:///dev/no_such_line").status(), Status::no_device);
  EXPECT_EQ(errno, ENOENT);
  EXPECT_EQ(open("serial:///dev/null").status(), Status::io_error);
  EXPECT_EQ(errno, ENOTTY);
}

}  // namespace
}  // namespace articam
