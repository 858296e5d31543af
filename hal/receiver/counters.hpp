#pragma once
/// @file  What has become of the packets.

#include <array>
#include <cstdint>

#include "hal/wire/fault.hpp"

namespace articam::receiver {

struct Counters {
  std::uint64_t packets{};                               ///< that came and were read
  std::uint64_t broken_frames{};                         ///< on a serial line: no packets, only noise or parts of some
  std::uint64_t estimates{};                             ///< newer than all before them: taken
  std::uint64_t models{};                                ///< packets with the names of the model
  std::uint64_t lost{};                                  ///< numbers that never came, or more than 64 packets late
  std::uint64_t reordered{};                             ///< came after a newer one: not used
  std::uint64_t duplicated{};                            ///< came twice: not used
  std::uint64_t sessions{};                              ///< starts of the board's program that were noticed
  std::array<std::uint64_t, wire::kNumFaults> faults{};  ///< refused, by their wire::Fault

  std::uint64_t refused() const noexcept {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : faults) sum += n;
    return sum;
  }
};

}  // namespace articam::receiver
