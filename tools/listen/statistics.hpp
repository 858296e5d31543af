#pragma once
/// @file  What was heard, in numbers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hal/wire/fault.hpp"
#include "tools/listen/sequence.hpp"
#include "tools/listen/spread.hpp"

namespace articam::listen {

struct Statistics {
  Counts estimates;  ///< of all sessions
  std::uint64_t sessions{};
  std::uint64_t unnamed{};        ///< estimates dropped because their model did not tell its names
  std::uint64_t broken_frames{};  ///< of a serial line
  std::array<std::uint64_t, wire::kNumFaults> faults{};
  Spread capture_to_send;  ///< the board's clock alone
  Spread send_to_receipt;  ///< exact if all came from this machine; otherwise beyond the quickest packet's
  bool exact{true};

  std::uint64_t bad() const;  ///< packets that were not used, whatever the reason
};

/// Latencies with minimum, median, 99 % and maximum; loss, and bad packets by reason.
std::string table(const Statistics& statistics);

/// The same in one line, while it goes on.
std::string status_line(const Statistics& statistics);

}  // namespace articam::listen
