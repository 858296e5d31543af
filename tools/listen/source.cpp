#include "tools/listen/source.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>

namespace articam::listen {
namespace {

/// A socket can be bound to our own addresses only.
bool is_of_this_machine(const std::array<std::uint8_t, 4>& host) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = std::bit_cast<in_addr_t>(host);
  const int probe = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool bound = ::bind(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  if (probe >= 0) ::close(probe);
  return bound;
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

std::string Source::open(const wire::Address& address) {
  constexpr int kQueue = 4 << 20;  // bytes: more than a second of the largest packets; the kernel gives what it allows
  is_serial_ = address.kind == wire::Address::Kind::serial;
  place_ = hal::place_of(address);
  const auto failed = inlet_.open(address, kQueue);
  return failed.empty() ? std::string{} : fail(failed);
}

std::string Source::fail(std::string_view what) {
  const int error = errno;
  problem_ = std::string{place_}.append(" ").append(what);
  if (error != 0) problem_.append(": ").append(std::strerror(error));
  return problem_;
}

std::optional<Received> Source::receive(std::chrono::milliseconds wait) {
  if (inlet_.wait(static_cast<int>(wait.count())) != Status::ok) return std::nullopt;
  hal::Inbound in;
  const Status status = inlet_.next(in);
  if (status == Status::io_error && is_serial_) fail("is gone");
  if (status != Status::ok) return std::nullopt;
  return Received{in.bytes, in.t_receipt, in.t_receipt_wall_ns, !is_serial_ && is_own(in.from)};
}

bool Source::is_own(const std::array<std::uint8_t, 4>& host) {
  if (host != last_host_) {
    last_host_ = host;
    last_is_own_ = is_of_this_machine(host);
  }
  return last_is_own_;
}

}  // namespace articam::listen
