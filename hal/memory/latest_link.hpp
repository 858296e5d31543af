#pragma once
/// @file  A link that keeps the newest estimate where the same program can read it.

#include <cstdint>

#include "core/status.hpp"

namespace articam::hal {

template <class Estimate>
class LatestLink {
 public:
  Status publish(const Estimate& estimate) noexcept {
    latest_ = estimate;
    ++published_;
    return Status::ok;
  }
  const Estimate& latest() const noexcept { return latest_; }
  std::uint64_t published() const noexcept { return published_; }

 private:
  Estimate latest_{};
  std::uint64_t published_{};
};

}  // namespace articam::hal
