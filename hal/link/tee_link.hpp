#pragma once
/// @file  A link that passes every estimate on and keeps the newest.

#include "core/status.hpp"

namespace articam::hal {

template <class Estimate, class Next>
class TeeLink {
 public:
  explicit TeeLink(Next& next) noexcept : next_{next} {}

  Status publish(const Estimate& estimate) noexcept {
    latest_ = estimate;
    return next_.publish(estimate);
  }
  const Estimate& latest() const noexcept { return latest_; }

 private:
  Next& next_;
  Estimate latest_{};
};

}  // namespace articam::hal
