#pragma once
/// @file  The numbers of the packets of one session: what was lost, came twice or came late.

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace articam::listen {

struct Counts {
  std::uint64_t received{};    ///< different ones
  std::uint64_t lost{};        ///< between the first heard and the newest
  std::uint64_t duplicates{};  ///< and those too old to tell
  std::uint64_t reordered{};   ///< of the received: came after a later one

  constexpr Counts& operator+=(const Counts& other) noexcept {
    received += other.received, lost += other.lost;
    duplicates += other.duplicates, reordered += other.reordered;
    return *this;
  }
};

/// Numbers wrap round; of two, the one less than half the circle ahead is the later.
class Sequence {
 public:
  static constexpr std::uint32_t kMemory = 1024;  ///< numbers: at 120 Hz more than 8 s late is too late

  /// True for a packet that was not heard before.
  bool take(std::uint32_t number);
  /// received + lost is the number of packets that were sent since the first one heard.
  Counts counts() const;

 private:
  std::uint64_t sent_{};  ///< from the first heard to the newest; 0 before any
  std::uint32_t newest_{};
  Counts counts_{};  ///< lost is not kept
  std::bitset<kMemory> heard_;
};

}  // namespace articam::listen
