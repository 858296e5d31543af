#pragma once
/// @file  A tracker that only counts what the loop asks of it.

#include "core/timestamp.hpp"
#include "core/tracker/estimate.hpp"
#include "core/vision/image_view.hpp"

namespace articam::test {

struct FakeEstimate {
  std::uint32_t frame{};
  Timestamp t_capture{};
  tracker::TrackingStatus status{};
  tracker::Reason reason{};
  bool valid{};
};

struct FakeTracker {
  using EstimateType = FakeEstimate;
  int steps{}, coasts{};
  FakeEstimate step(const ImageView&, Timestamp t) noexcept {
    return ++steps, FakeEstimate{0, t, tracker::TrackingStatus::tracking, tracker::Reason::none, true};
  }
  FakeEstimate coast(Timestamp t, tracker::Reason why) noexcept {
    return ++coasts, FakeEstimate{0, t, tracker::TrackingStatus::coasting, why, true};
  }
};

}  // namespace articam::test
