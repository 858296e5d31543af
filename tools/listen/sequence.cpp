#include "tools/listen/sequence.hpp"

#include <algorithm>

namespace articam::listen {

bool Sequence::take(std::uint32_t number) {
  const auto ahead = static_cast<std::int32_t>(number - newest_);  // the number may wrap round
  const std::uint32_t behind = newest_ - number;
  if (sent_ == 0) {
    newest_ = number;
    sent_ = 1;
  } else if (ahead > 0) {
    // The places of the numbers skipped still tell of numbers kMemory before them.
    const std::uint32_t skipped = std::min(static_cast<std::uint32_t>(ahead) - 1, kMemory - 1);
    for (std::uint32_t i = 1; i <= skipped; ++i) heard_.reset((number - i) % kMemory);
    newest_ = number;
    sent_ += static_cast<std::uint64_t>(ahead);
  } else if (behind >= kMemory || heard_.test(number % kMemory)) {
    ++counts_.duplicates;
    return false;
  } else {
    ++counts_.reordered;
    sent_ = std::max(sent_, std::uint64_t{behind} + 1);
  }
  heard_.set(number % kMemory);
  ++counts_.received;
  return true;
}

Counts Sequence::counts() const {
  Counts counts = counts_;
  counts.lost = sent_ - counts.received;
  return counts;
}

}  // namespace articam::listen
