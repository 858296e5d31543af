#include "tools/listen/sequence.hpp"

#include <algorithm>

namespace articam::listen {

bool Sequence::take(std::uint32_t number) {
  if (!any_) {
    any_ = true;
    first_ = newest_ = number;
  } else if (number > newest_) {
    // The places of the numbers skipped still tell of numbers kMemory before them.
    const std::uint32_t skipped = std::min(number - newest_ - 1, kMemory - 1);
    for (std::uint32_t i = 1; i <= skipped; ++i) heard_.reset((number - i) % kMemory);
    newest_ = number;
  } else if (newest_ - number >= kMemory || heard_.test(number % kMemory)) {
    ++counts_.duplicates;
    return false;
  } else {
    ++counts_.reordered;
    first_ = std::min(first_, number);
  }
  heard_.set(number % kMemory);
  ++counts_.received;
  return true;
}

Counts Sequence::counts() const {
  Counts counts = counts_;
  if (any_) counts.lost = std::uint64_t{newest_} - first_ + 1 - counts.received;
  return counts;
}

}  // namespace articam::listen
