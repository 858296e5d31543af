#include "tools/listen/source.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>

#include "tools/listen/serial_line.hpp"

namespace articam::listen {
namespace {

std::int64_t now_ns(clockid_t clock) {
  timespec t{};
  ::clock_gettime(clock, &t);
  return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

sockaddr_in socket_address(in_addr_t host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = host;
  address.sin_port = htons(port);
  return address;
}

bool bind_to(int descriptor, const sockaddr_in& address) {
  return ::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

template <class T>
bool set(int descriptor, int level, int option, const T& value) {
  return ::setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

std::string with_scheme(std::string_view scheme, std::string_view text) {
  return text.find("://") == std::string_view::npos ? std::string{scheme}.append(text) : std::string{text};
}

}  // namespace

std::string parse_udp(std::string_view text, wire::Address& out) {
  const bool port_only = !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  // Any group does to have the port read.
  const std::string address = port_only ? std::string{"udp://239.0.0.0:"}.append(text) : with_scheme("udp://", text);
  wire::Address parsed;
  std::string problem{wire::parse_address(address, parsed)};
  if (problem.empty() && parsed.kind != wire::Address::Kind::udp) problem = "is a serial line: give it to --serial";
  if (port_only) parsed.host = {};
  if (problem.empty()) out = parsed;
  return problem;
}

std::string parse_serial(std::string_view text, wire::Address& out) {
  wire::Address parsed;
  std::string problem{wire::parse_address(with_scheme("serial://", text), parsed)};
  if (problem.empty() && parsed.kind != wire::Address::Kind::serial) problem = "is a UDP address: give it to --udp";
  if (problem.empty()) out = parsed;
  return problem;
}

Source::~Source() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string Source::open(const wire::Address& address) {
  is_serial_ = address.kind == wire::Address::Kind::serial;
  return is_serial_ ? open_serial(address) : open_udp(address);
}

std::string Source::open_udp(const wire::Address& address) {
  constexpr int kRoom = 4 << 20;  // bytes: more than a second of the largest packets; the kernel gives what it allows
  constexpr int kOn = 1;
  const auto host = std::bit_cast<in_addr_t>(address.host);
  name_ = "UDP port " + std::to_string(address.port);
  descriptor_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor_ < 0) return fail("cannot be opened");
  set(descriptor_, SOL_SOCKET, SO_RCVBUF, kRoom);
  // Several listeners may share a group, never a port: the kernel would give each packet to one of them only.
  if (address.is_multicast() && !set(descriptor_, SOL_SOCKET, SO_REUSEADDR, kOn)) return fail("cannot be shared");
  if (!bind_to(descriptor_, socket_address(host, address.port))) return fail("cannot be listened on");
  const ip_mreq group{{host}, {std::bit_cast<in_addr_t>(address.via)}};
  if (address.is_multicast() && !set(descriptor_, IPPROTO_IP, IP_ADD_MEMBERSHIP, group)) {
    return fail("the group cannot be joined; with ?via=ADDRESS you choose the interface");
  }
  return {};
}

std::string Source::open_serial(const wire::Address& address) {
  name_ = address.device.data();
  descriptor_ = open_serial_line(address.device.data(), address.baud);
  return descriptor_ >= 0 ? std::string{} : fail("cannot be opened as a serial line");
}

std::string Source::fail(const std::string& what) {
  problem_ = name_ + ": " + what + ": " + std::strerror(errno);
  return problem_;
}

std::optional<Received> Source::receive(std::chrono::milliseconds wait) {
  if (next_ < end_) {
    if (auto frame = next_frame()) return frame;
  }
  pollfd ready{descriptor_, POLLIN, 0};
  if (::poll(&ready, 1, static_cast<int>(wait.count())) <= 0) return std::nullopt;
  if (!is_serial_) return receive_datagram();
  const ssize_t size = ::read(descriptor_, buffer_.data(), buffer_.size());
  if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) {
    if (size == 0) errno = EIO;
    fail("the line is gone");
  }
  next_ = 0;
  end_ = static_cast<std::size_t>(std::max<ssize_t>(size, 0));
  return next_frame();
}

std::optional<Received> Source::receive_datagram() {
  sockaddr_in from{};
  socklen_t from_size = sizeof from;
  const ssize_t size =
      ::recvfrom(descriptor_, buffer_.data(), buffer_.size(), 0, reinterpret_cast<sockaddr*>(&from), &from_size);
  if (size < 0) return std::nullopt;
  return stamped(std::span{buffer_}.first(static_cast<std::size_t>(size)), is_own(from.sin_addr.s_addr));
}

std::optional<Received> Source::next_frame() {
  using Event = decltype(decoder_)::Event;
  while (next_ < end_) {
    const Event event = decoder_.take(buffer_[next_++]);
    if (event == Event::broken) ++broken_frames_;
    if (event == Event::frame) return stamped(decoder_.frame(), false);
  }
  return std::nullopt;
}

/// A socket can be bound to our own addresses only.
bool Source::is_own(std::uint32_t host) {
  if (host == last_host_) return last_is_own_;
  const int probe = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  last_host_ = host;
  last_is_own_ = probe >= 0 && bind_to(probe, socket_address(host, 0));
  if (probe >= 0) ::close(probe);
  return last_is_own_;
}

Received Source::stamped(std::span<const std::uint8_t> bytes, bool same_machine) const {
  return {bytes, {now_ns(CLOCK_MONOTONIC)}, now_ns(CLOCK_REALTIME), same_machine};
}

}  // namespace articam::listen
