#pragma once
/// @file  A serial line without hardware: the far end of a pseudo terminal.

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hal/wire/cobs.hpp"

namespace articam::test {

class PseudoTerminal {
 public:
  PseudoTerminal() {
    if (far_ >= 0 && (::grantpt(far_) != 0 || ::unlockpt(far_) != 0)) hang_up();
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal() { hang_up(); }

  bool works() const { return far_ >= 0; }
  std::string path() const { return ::ptsname(far_); }  ///< of the near end

  bool say(std::span<const std::uint8_t> bytes) const {
    return ::write(far_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }
  /// What the near end has then is a line that is gone.
  void hang_up() {
    if (far_ >= 0) ::close(std::exchange(far_, -1));
  }

 private:
  int far_{::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)};
};

/// As it goes over the line, its delimiter included.
inline std::vector<std::uint8_t> framed(std::span<const std::uint8_t> packet) {
  std::vector<std::uint8_t> frame(2 * packet.size() + 2);  // always enough
  frame.resize(wire::cobs_encode(packet, frame).value());
  return frame;
}

}  // namespace articam::test
