#pragma once
/// @file  Where a packet goes or comes from, as people write it.
///
///     udp://239.1.1.1:47047                a multicast group; the port may be left out
///     udp://10.0.0.2                       one host
///     udp://239.1.1.1?ttl=4&via=10.0.0.1   through 3 routers, by the interface of that address
///     serial:///dev/ttyS1?baud=921600      a serial line, 8 data bits, no parity

#include <array>
#include <cstdint>
#include <string_view>

namespace articam::wire {

inline constexpr std::uint16_t kDefaultPort = 47047;
/// Where a board sends and a listener listens when nobody says: a group of this network (RFC 2365, organization-local).
inline constexpr std::string_view kDefaultAddress = "udp://239.255.47.47:47047";
inline constexpr std::uint32_t kDefaultBaud = 921600;

struct Address {
  enum class Kind : std::uint8_t { udp, serial };

  Kind kind{Kind::udp};
  std::array<std::uint8_t, 4> host{};  ///< IPv4, as written
  std::uint16_t port{kDefaultPort};
  std::uint8_t ttl{1};                ///< of multicast packets: 1 does not leave the local network
  std::array<std::uint8_t, 4> via{};  ///< address of the interface for multicast; 0.0.0.0 lets the system choose
  std::array<char, 64> device{};      ///< path, ends with a zero
  std::uint32_t baud{kDefaultBaud};

  constexpr bool is_multicast() const noexcept { return kind == Kind::udp && host[0] >= 224 && host[0] <= 239; }
};

/// Empty when `out` holds the address; else `out` is untouched and this is a sentence that says what to write instead.
std::string_view parse_address(std::string_view text, Address& out) noexcept;

}  // namespace articam::wire
