#pragma once
/// @file  Whether the receiver can hear at all.

#include <cstdint>

namespace articam::receiver {

/// A socket or a line that fails later than start() is opened anew ten times a second, until it works: an adapter that
/// was unplugged comes back. Silence of the board is no failure: Reading::silence_s tells it.
struct Health {
  enum class State : std::uint8_t {
    stopped,    ///< before start() and after stop()
    listening,  ///< what the board sends is heard
    broken,     ///< `error` keeps it from being heard
  };

  State state{State::stopped};
  int error{};               ///< errno: why it is broken, such as ENETDOWN or EIO; 0 while it is not
  std::uint64_t failures{};  ///< since start(): how often it was broken

  constexpr bool operator==(const Health&) const noexcept = default;
};

}  // namespace articam::receiver
