#include "hal/wire/address.hpp"

#include <algorithm>
#include <cstddef>

namespace articam::wire {
namespace {

/// Takes the text up to the first `end`, and `end` itself; all of it when there is none.
std::string_view take_until(std::string_view& text, char end) noexcept {
  const std::string_view part{text.begin(), std::ranges::find(text, end)};
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

/// A decimal number without sign from 0 to `largest`.
bool read_number(std::string_view text, std::uint32_t largest, std::uint32_t& out) noexcept {
  if (text.empty() || text.size() > 9) return false;
  std::uint32_t x = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return false;
    x = 10 * x + static_cast<std::uint32_t>(c - '0');
  }
  out = x;
  return x <= largest;
}

bool read_host(std::string_view text, std::array<std::uint8_t, 4>& out) noexcept {
  if (std::ranges::count(text, '.') != 3) return false;
  for (std::uint8_t& byte : out) {
    std::uint32_t x = 0;
    if (!read_number(take_until(text, '.'), 255, x)) return false;
    byte = static_cast<std::uint8_t>(x);
  }
  return true;
}

/// Empty, or why `name=value` does not suit such an address.
std::string_view read_option(std::string_view option, Address& out) noexcept {
  const std::string_view name = take_until(option, '=');
  std::uint32_t x = 0;
  if (name == "ttl" && out.is_multicast()) {
    if (!read_number(option, 255, x) || x == 0) return "ttl is a number from 1 to 255";
    out.ttl = static_cast<std::uint8_t>(x);
    return {};
  }
  if (name == "via" && out.is_multicast()) {
    return read_host(option, out.via) ? "" : "via is the IPv4 address of an own interface, such as via=10.0.0.1";
  }
  if (name == "baud" && out.kind == Address::Kind::serial) {
    return read_number(option, 4'000'000, out.baud) && out.baud > 0 ? "" : "baud is a number such as 115200 or 921600";
  }
  return out.kind == Address::Kind::serial ? "the only option of a serial line is baud=NUMBER"
                                           : "the options are ttl=NUMBER and via=ADDRESS, for multicast groups only";
}

std::string_view read_udp(std::string_view text, Address& out) noexcept {
  const bool has_port = std::ranges::count(text, ':') != 0;
  if (!read_host(take_until(text, ':'), out.host)) return "the host is an IPv4 address in numbers, such as 10.0.0.2";
  if (out.host[0] == 0 || out.host[0] > 239) {
    return "0.x.x.x and 240.0.0.0 to 255.255.255.255 name no host: use the address of one, or a group such as "
           "239.1.1.1";
  }
  std::uint32_t port = kDefaultPort;
  if (has_port && (!read_number(text, 65535, port) || port == 0)) return "the port is a number from 1 to 65535";
  out.port = static_cast<std::uint16_t>(port);
  return {};
}

std::string_view read_serial(std::string_view text, Address& out) noexcept {
  if (!text.starts_with('/')) return "the device is a whole path, such as serial:///dev/ttyS1";
  if (text.size() >= out.device.size()) return "the path of the device is longer than 63 characters";
  std::ranges::copy(text, out.device.begin());
  return {};
}

}  // namespace

std::string_view parse_address(std::string_view text, Address& out) noexcept {
  constexpr std::string_view kUdp = "udp://", kSerial = "serial://";
  Address address;
  std::string_view options = text;
  std::string_view place = take_until(options, '?');
  std::string_view problem;
  if (place.starts_with(kUdp)) {
    problem = read_udp(place.substr(kUdp.size()), address);
  } else if (place.starts_with(kSerial)) {
    address.kind = Address::Kind::serial;
    problem = read_serial(place.substr(kSerial.size()), address);
  } else {
    problem = "an address begins with udp:// or serial://, such as udp://239.1.1.1:47047 or serial:///dev/ttyS1";
  }
  while (problem.empty() && !options.empty()) problem = read_option(take_until(options, '&'), address);
  if (problem.empty()) out = address;
  return problem;
}

}  // namespace articam::wire
