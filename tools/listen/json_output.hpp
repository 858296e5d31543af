#pragma once
/// @file  Estimates -> JSON over UDP, for PlotJuggler's "UDP Server" with the protocol "json".

#include <netinet/in.h>

#include <cstdint>
#include <string>

#include "hal/wire/address.hpp"
#include "tools/listen/output.hpp"

namespace articam::listen {

inline constexpr std::uint16_t kPlotJugglerPort = 9870;

/// One object without line breaks. `timestamp` is the capture on the host's clock, s since 1970.
std::string to_json(const Heard& heard);

/// That nobody listens is no failure: the plotting program may be started later.
class JsonOutput : public Output {
 public:
  JsonOutput() = default;
  JsonOutput(const JsonOutput&) = delete;
  JsonOutput& operator=(const JsonOutput&) = delete;
  ~JsonOutput() override;

  /// Empty, or why it cannot send there.
  std::string open(const wire::Address& address);
  std::string take(const Heard& heard) override;

 private:
  int descriptor_{-1};
  sockaddr_in peer_{};
};

}  // namespace articam::listen
